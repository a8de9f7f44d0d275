#include "sample.hpp"

namespace qtraj {

const Kernel kPlainKernel = {"scalar plain", sample<Plain, double>, sample<Plain, float>};

}  // namespace qtraj
