// The functions from rows to rows, as a table, so that one test of a rule holds for all of them.
#ifndef QTRAJ_TESTS_ROW_FUNCTIONS_HPP
#define QTRAJ_TESTS_ROW_FUNCTIONS_HPP

#include <qtraj.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "support/random.hpp"

namespace test {

struct RowInput {
  size_t width;
  bool needs_norm = false;  // a quaternion that must not be 0
};

template <class Real>
struct RowFunction {
  const char* name;
  std::vector<RowInput> inputs;
  std::vector<size_t> outputs;  // widths
  bool can_overflow;
  std::function<qtraj_status(const Real* const* in, size_t count, Real* const* out, size_t* bad_index)> call;

  // Whether every kernel gives the same bits, those of another kind too.
  bool is_same_everywhere() const {
    const char* const of_a_kind[] = {"multiply",
                                     "inverse",
                                     "norm",
                                     "rotate",
                                     "exp",
                                     "q_from_rotation_vector",
                                     "log",
                                     "rotation_vector_from_q",
                                     "pow",
                                     "distance",
                                     "rotation_angle",
                                     "matrix_from_q",
                                     "q_from_matrix"};
    const std::string whole = name, root = whole.substr(0, whole.find("_f32"));
    return std::find(std::begin(of_a_kind), std::end(of_a_kind), root) == std::end(of_a_kind);
  }
};

// Rows without a fault: unit quaternions, vectors and numbers about 1, rotation matrices.
template <class Real>
std::vector<Real> good_rows(size_t width, size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Real> rows;
  for (size_t row = 0; row < count; ++row) {
    const Quaternion q = random.orientation();
    double matrix[9];
    if (width == 9) qtraj_matrix_from_q(q.data(), 1, matrix, nullptr);
    for (size_t k = 0; k < width; ++k)
      rows.push_back(static_cast<Real>(width == 9 ? matrix[k] : width == 4 ? q[k] : random.uniform(-2, 2)));
  }
  return rows;
}

// Data of the arrays of a call.
template <class Real>
struct RowArrays {
  std::vector<std::vector<Real>> in, out;

  RowArrays(const RowFunction<Real>& function, size_t count) {
    for (size_t k = 0; k < function.inputs.size(); ++k)
      in.push_back(good_rows<Real>(function.inputs[k].width, count, 100 + k));
    for (const size_t width : function.outputs) out.emplace_back(width * count, Real(7));
  }
  qtraj_status call(const RowFunction<Real>& function, size_t count, size_t* bad_index) {
    return function.call(inputs().data(), count, outputs().data(), bad_index);
  }
  std::vector<const Real*> inputs() const {
    std::vector<const Real*> pointers;
    for (const std::vector<Real>& array : in) pointers.push_back(array.data());
    return pointers;
  }
  std::vector<Real*> outputs() {
    std::vector<Real*> pointers;
    for (std::vector<Real>& array : out) pointers.push_back(array.data());
    return pointers;
  }
};

inline std::vector<RowFunction<float>> row_functions(float) {
  return {
      {"rotate_f32",
       {{4, true}, {3}},
       {3},
       true,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_rotate_f32(in[0], count, in[1], count, count, out[0], bad);
       }},
      {"multiply_f32",
       {{4}, {4}},
       {4},
       true,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_multiply_f32(in[0], count, in[1], count, count, out[0], bad);
       }},
      {"matrix_from_q_f32",
       {{{4, true}}},
       {9},
       false,
       [](auto in, size_t count, auto out, size_t* bad) { return qtraj_matrix_from_q_f32(in[0], count, out[0], bad); }},
      {"q_from_matrix_f32",
       {{{9}}},
       {4},
       true,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_q_from_matrix_f32(in[0], count, 0, out[0], nullptr, bad);
       }},
      {"exp_f32",
       {{{3}}},
       {4},
       false,
       [](auto in, size_t count, auto out, size_t* bad) { return qtraj_exp_f32(in[0], count, out[0], bad); }},
      {"q_from_rotation_vector_f32",
       {{{3}}},
       {4},
       false,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_q_from_rotation_vector_f32(in[0], count, out[0], bad);
       }},
      {"log_f32",
       {{{4, true}}},
       {3},
       false,
       [](auto in, size_t count, auto out, size_t* bad) { return qtraj_log_f32(in[0], count, out[0], bad); }},
      {"rotation_vector_from_q_f32",
       {{{4, true}}},
       {3},
       false,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_rotation_vector_from_q_f32(in[0], count, out[0], bad);
       }},
      {"distance_f32",
       {{4, true}, {4, true}},
       {1},
       false,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_distance_f32(in[0], count, in[1], count, count, out[0], bad);
       }},
      {"screw_pairs_f32",
       {{4, true}, {3}, {4, true}, {3}, {1}},
       {4, 3},
       true,
       [](auto in, size_t count, auto out, size_t* bad) {
         return qtraj_screw_pairs_f32(in[0], in[1], count, in[2], in[3], count, in[4], count, count, out[0], out[1],
                                      bad);
       }}};
}

inline std::vector<RowFunction<double>> row_functions(double) {
  using In = const double* const*;
  using Out = double* const*;
  const RowInput any = {4}, q = {4, true}, vector = {3}, number = {1}, matrix = {9};
  std::vector<RowFunction<double>> functions;
  // functions of one input
  const auto add = [&](const char* name, const RowInput& input, size_t output, bool can_overflow,
                       qtraj_status (*function)(const double*, size_t, double*, size_t*)) {
    functions.push_back({name, {input}, {output}, can_overflow, [=](In in, size_t n, Out out, size_t* bad) {
                           return function(in[0], n, out[0], bad);
                         }});
  };
  add("conjugate", any, 4, false, qtraj_conjugate);
  add("inverse", q, 4, true, qtraj_inverse);
  add("norm", any, 1, true, qtraj_norm);
  add("exp", vector, 4, false, qtraj_exp);
  add("log", q, 3, false, qtraj_log);
  add("rotation_vector_from_q", q, 3, false, qtraj_rotation_vector_from_q);
  add("q_from_rotation_vector", vector, 4, false, qtraj_q_from_rotation_vector);
  add("matrix_from_q", q, 9, false, qtraj_matrix_from_q);
  functions.push_back({"q_from_matrix", {matrix}, {4}, true, [](In in, size_t n, Out out, size_t* bad) {
                         return qtraj_q_from_matrix(in[0], n, 0, out[0], nullptr, bad);
                       }});
  // of two, with counts of their own
  const auto add_pair =
      [&](const char* name, const RowInput& a, const RowInput& b, size_t output, bool can_overflow,
          qtraj_status (*function)(const double*, size_t, const double*, size_t, size_t, double*, size_t*)) {
        functions.push_back({name, {a, b}, {output}, can_overflow, [=](In in, size_t n, Out out, size_t* bad) {
                               return function(in[0], n, in[1], n, n, out[0], bad);
                             }});
      };
  add_pair("multiply", any, any, 4, true, qtraj_multiply);
  add_pair("rotate", q, vector, 3, true, qtraj_rotate);
  add_pair("dot", any, any, 1, true, qtraj_dot);
  add_pair("distance", q, q, 1, false, qtraj_distance);
  add_pair("rotation_angle", q, q, 1, false, qtraj_rotation_angle);
  functions.push_back({"pow", {q, number}, {4}, false, [](In in, size_t n, Out out, size_t* bad) {
                         return qtraj_pow(in[0], in[1], n, n, out[0], bad);
                       }});
  functions.push_back(
      {"screw_pairs", {q, vector, q, vector, number}, {4, 3}, true, [](In in, size_t n, Out out, size_t* bad) {
         return qtraj_screw_pairs(in[0], in[1], n, in[2], in[3], n, in[4], n, n, out[0], out[1], bad);
       }});
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
    functions.push_back(
        {"derivatives_from_rates", {q, vector, vector}, {4, 4}, true, [=](In in, size_t n, Out out, size_t* bad) {
           return qtraj_derivatives_from_rates(frame, in[0], in[1], in[2], n, out[0], out[1], bad);
         }});
    functions.push_back(
        {"first derivatives_from_rates", {q, vector}, {4}, true, [=](In in, size_t n, Out out, size_t* bad) {
           return qtraj_derivatives_from_rates(frame, in[0], in[1], nullptr, n, out[0], nullptr, bad);
         }});
    functions.push_back(
        {"rates_from_derivatives", {q, any, any}, {3, 3}, true, [=](In in, size_t n, Out out, size_t* bad) {
           return qtraj_rates_from_derivatives(frame, in[0], in[1], in[2], n, out[0], out[1], bad);
         }});
    functions.push_back(
        {"first rates_from_derivatives", {q, any}, {3}, true, [=](In in, size_t n, Out out, size_t* bad) {
           return qtraj_rates_from_derivatives(frame, in[0], in[1], nullptr, n, out[0], nullptr, bad);
         }});
  }
  return functions;
}

// Calls body(function, Real()) for each function of the table, double and float.
template <class Body>
void for_each_row_function(Body&& body) {
  for (const RowFunction<double>& function : row_functions(double())) body(function, double());
  for (const RowFunction<float>& function : row_functions(float())) body(function, float());
}

}  // namespace test

#endif
