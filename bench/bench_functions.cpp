// Functions over rows, in the caches and past them, beside a plain loop (loops.hpp), Eigen where it has the function,
// and the time that memory takes to move the same bytes.
#include <cstdint>

#include "row_functions.hpp"

namespace bench {
namespace {

// Turns of up to half a turn; neighbours up to 0.2 rad apart.
std::vector<double> rows_of(Kind kind, size_t count, uint64_t seed) {
  Random random(seed);
  if (kind == Kind::orientation) return orientations_of(count, seed);
  std::vector<double> rows;
  test::Quaternion q = random.orientation();
  for (size_t i = 0; i < count; ++i) {
    const double time = 0.01 * static_cast<double>(i);
    const auto stamp = static_cast<int64_t>(i) * 10000019;
    double number = random.uniform(0, 1), matrix[9];
    switch (kind) {
      case Kind::neighbour:
        q = test::multiply(q, test::turn_within(random, 0.2));
        rows.insert(rows.end(), q.begin(), q.end());
        break;
      case Kind::turn:
        q = random.orientation();
        rows.resize(rows.size() + 3);
        must_be_ok(qtraj_rotation_vector_from_q(q.data(), 1, &rows[3 * i], nullptr));
        break;
      case Kind::vector:
        for (size_t k = 0; k < 3; ++k) rows.push_back(random.uniform(-2, 2));
        break;
      case Kind::matrix:
        q = random.orientation();
        must_be_ok(qtraj_matrix_from_q(q.data(), 1, matrix, nullptr));
        rows.insert(rows.end(), matrix, matrix + 9);
        break;
      case Kind::stamp:
        std::memcpy(&number, &stamp, sizeof number);
        rows.push_back(number);
        break;
      default:
        if (kind == Kind::time) number = time;
        if (kind == Kind::number) number = 2 * number - 1;
        if (kind == Kind::late) number += static_cast<double>(count);
        rows.push_back(number);
    }
  }
  return rows;
}

// ---- Loops for the target in use ----

template <class Real>
struct Loops {
  const NamedLoop<Real>* named;
  void (*move_bytes)(const Bytes<const char>*, size_t, const Bytes<char>*, size_t);
};

#define QTRAJ_RETURN_LOOPS(target, arithmetic, runs_here, unused)       \
  if (std::strncmp(qtraj_target(), #target " ", sizeof #target) == 0) { \
    if constexpr (sizeof(Real) == sizeof(double))                       \
      return {loops_##target::doubles, loops_##target::move_bytes};     \
    else                                                                \
      return {loops_##target::floats, loops_##target::move_bytes};      \
  }
template <class Real>
Loops<Real> loops() {
  QTRAJ_EACH_TARGET(QTRAJ_RETURN_LOOPS, )
  std::fprintf(stderr, "bench: no loops for %s\n", qtraj_target());
  std::exit(1);
}

template <class Real>
RowLoop<Real> loop_of(const char* name) {
  const NamedLoop<Real>* at = loops<Real>().named;
  while (at->name && std::strcmp(at->name, name) != 0) ++at;
  return at->loop;
}

// ---- Rows ----

// The inputs of a call, and its outputs one after the other in one array.
template <class Real>
struct Arrays {
  std::vector<std::vector<Real>> in;
  std::vector<const Real*> inputs;
  std::vector<size_t> widths;
  size_t count;

  Arrays(const Function<Real>& function, size_t rows) : widths(function.out), count(rows) {
    for (size_t k = 0; k < function.in.size(); ++k) in.push_back(converted<Real>(rows_of(function.in[k], rows, 1 + k)));
    for (const std::vector<Real>& each : in) inputs.push_back(each.data());
  }
  Arrays(Arrays&&) = default;

  std::vector<Real*> outputs(Real* out) const {
    std::vector<Real*> pointers;
    for (const size_t width : widths) {
      pointers.push_back(out);
      out += width * count;
    }
    return pointers;
  }
};

template <class Real>
void add_function(const Function<Real>& function, size_t count) {
  size_t components = 0;
  for (const size_t width : function.out) components += width;
  const Case rows = {with_type<Real>((std::string("rows_") + function.name).c_str()), 0, count};
  const auto add_who = [&](const char* who, const auto& call) {
    add<Real>(
        rows, who,
        [=] {
          return [=, arrays = std::make_shared<Arrays<Real>>(function, count)](Real* out) {
            call(*arrays, arrays->outputs(out).data());
          };
        },
        components);
  };
  add_who("ours", [=](const Arrays<Real>& arrays, Real* const* out) {
    must_be_ok(function.ours(arrays.inputs.data(), count, out));
  });
  if (const RowLoop<Real> loop = loop_of<Real>(function.name))
    add_who("loop", [=](const Arrays<Real>& arrays, Real* const* out) { loop(arrays.inputs.data(), count, out); });
  if (function.eigen)
    add_who("eigen",
            [=](const Arrays<Real>& arrays, Real* const* out) { function.eigen(arrays.inputs.data(), count, out); });
  add_who("bytes", [=](const Arrays<Real>& arrays, Real* const* out) {
    std::vector<Bytes<const char>> from;
    std::vector<Bytes<char>> to;
    for (const std::vector<Real>& each : arrays.in)
      from.push_back({reinterpret_cast<const char*>(each.data()), each.size() * sizeof(Real)});
    for (size_t k = 0; k < arrays.widths.size(); ++k)
      to.push_back({reinterpret_cast<char*>(out[k]), arrays.widths[k] * count * sizeof(Real)});
    loops<Real>().move_bytes(from.data(), from.size(), to.data(), to.size());
  });
}

}  // namespace

void add_functions() {
  for (const size_t count : {1000, 1000000}) {
    for (const Function<double>& function : row_functions(0.0)) add_function(function, count);
    for (const Function<float>& function : row_functions(0.0f)) add_function(function, count);
  }
}

}  // namespace bench
