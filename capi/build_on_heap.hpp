// Curves on the heap.
#pragma once

#include "arguments.hpp"
#include "methods/timeline_builder.hpp"

namespace qtraj::capi {

// Allocates a handle and a workspace, lets build(handle, workspace) make `built` there, and frees what is not kept.
template <class Record, class Build>
Outcome build_on_heap(const CurveSize& size, Record*& built, const Build& build) {
  void* const handle = allocate(size.handle);
  void* const workspace = size.workspace > 0 ? allocate(size.workspace) : nullptr;
  Outcome outcome = {Status::no_memory, kNoIndex};
  if (handle && (workspace || size.workspace == 0)) outcome = build(handle, workspace);
  release(workspace);
  if (outcome.status == Status::ok)
    built->on_heap = true;
  else
    release(handle);
  return outcome;
}

}  // namespace qtraj::capi
