// The kernels over the keys and segments of a constructor (rows/clean_keys.hpp, rows/segments.hpp). Compiled for every
// target.
#include "rows/segments.hpp"

#include "rows/clean_keys.hpp"
#include "rows/hermite.hpp"
#include "rows/squad.hpp"
#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t clean_keys(const CleanRows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return qtraj::clean_keys<Number>(rows, first, count);
}

size_t arcs(const ArcRows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return qtraj::arcs<Number>(rows, first, count);
}

size_t hermite(const HermiteRows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return qtraj::hermite<Number>(rows, first, count);
}

size_t squad_chords(const SquadRows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return qtraj::squad_chords<Number>(rows, first, count);
}

size_t squad_half_rates(const SquadRows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return qtraj::squad_half_rates<Number>(rows, first, count);
}

size_t squad_segments(const SquadRows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return qtraj::squad_segments<Number>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
