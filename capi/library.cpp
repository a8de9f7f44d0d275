#include "arguments.hpp"
#include "targets/targets.hpp"

namespace {

struct StatusRow {
  qtraj_status status;
  qtraj_class_value kind;
  const char* text;
};
constexpr StatusRow kStatuses[] = {
    {QTRAJ_OK, QTRAJ_CLASS_DONE, "success"},
    {QTRAJ_E_NULL, QTRAJ_CLASS_REFUSED, "a required pointer is NULL: pass the array, or a count of 0"},
    {QTRAJ_E_HANDLE, QTRAJ_CLASS_REFUSED, "not a handle of this kind, or destroyed: pass what the constructor gave"},
    {QTRAJ_E_TOO_FEW, QTRAJ_CLASS_REFUSED, "too few elements: pass 2 keys, 1 sample of a mean, or more"},
    {QTRAJ_E_COUNT, QTRAJ_CLASS_REFUSED, "counts do not belong together: each is 1 or that of the call"},
    {QTRAJ_E_SIZE, QTRAJ_CLASS_REFUSED, "array larger than the address space: look for a count that was never set"},
    {QTRAJ_E_VALUE, QTRAJ_CLASS_REFUSED, "not a constant of this family, or a value out of its range: check it"},
    {QTRAJ_E_SETTING, QTRAJ_CLASS_REFUSED, "the method does not have this setting: leave it out"},
    {QTRAJ_E_INPUT_MISSING, QTRAJ_CLASS_REFUSED,
     "rates, turns or tangents are missing: pass them, or the rates of the ends"},
    {QTRAJ_E_INPUT_UNWANTED, QTRAJ_CLASS_REFUSED,
     "rates, turns or tangents that method and settings do not use: pass NULL"},
    {QTRAJ_E_BUFFER, QTRAJ_CLASS_REFUSED, "memory too small or not aligned to 8 bytes: ask qtraj_init_size"},
    {QTRAJ_E_OVERLAP, QTRAJ_CLASS_REFUSED, "an output overlaps another array: give it an array of its own"},
    {QTRAJ_E_NO_MEMORY, QTRAJ_CLASS_REFUSED, "out of memory: free some, or use qtraj_init"},
    {QTRAJ_E_NOT_FINITE, QTRAJ_CLASS_DATA, "NaN or infinity, or a result that overflows: leave this element out"},
    {QTRAJ_E_ZERO_NORM, QTRAJ_CLASS_DATA, "quaternion of norm 0, or weights that are all 0: leave this element out"},
    {QTRAJ_E_TIME_ORDER, QTRAJ_CLASS_DATA, "time does not come after the one before: sort, leave repeats out"},
    {QTRAJ_E_TIME_RANGE, QTRAJ_CLASS_DATA, "time outside the knots: stay inside or set an extrapolation"},
    {QTRAJ_E_TIME_SPAN, QTRAJ_CLASS_DATA, "the span of the times overflows: look for a wrong time"},
    {QTRAJ_E_GAP, QTRAJ_CLASS_DATA, "time inside an interval longer than the longest gap: there are no data"},
    {QTRAJ_E_NEGATIVE_WEIGHT, QTRAJ_CLASS_DATA, "weight below 0: make it 0 or more"},
    {QTRAJ_E_NOT_CLOSED, QTRAJ_CLASS_DATA, "the last key is not the first: append it, set a period or a closure"},
    {QTRAJ_E_NOT_ROTATION, QTRAJ_CLASS_DATA, "matrix too far from a rotation: look for a scale or a reflection"},
    {QTRAJ_E_RATE_TOO_FAST, QTRAJ_CLASS_DATA, "rate too fast for an interval beside it: look at its unit"},
    {QTRAJ_E_NO_CONVERGENCE, QTRAJ_CLASS_DATA, "no curve found, iterations or pieces ran out: see the function"},
    {QTRAJ_E_AMBIGUOUS, QTRAJ_CLASS_ONE_OF_SEVERAL,
     "more than one answer is equally right: see the rule of the function"},
    {QTRAJ_E_INTERNAL, QTRAJ_CLASS_DEFECT, "defect of the library: please report it"},
};

const StatusRow* find_status(int32_t status) {
  for (const StatusRow& row : kStatuses)
    if (row.status == status) return &row;
  return nullptr;
}

}  // namespace

extern "C" {

const char* qtraj_version(void) { return QTRAJ_VERSION_STRING; }

int32_t qtraj_version_number(void) { return QTRAJ_VERSION_NUMBER; }

const char* qtraj_target(void) { return qtraj::target_name(qtraj::target()); }

const char* qtraj_status_text(int32_t status) {
  const StatusRow* row = find_status(status);
  return row ? row->text : "unknown status";
}

int32_t qtraj_status_class(int32_t status) {
  const StatusRow* row = find_status(status);
  return row ? row->kind : QTRAJ_CLASS_DEFECT;
}

}  // extern "C"
