#include "core/kinematics/block_kernels.h"

#include "core/kinematics/block_kernel_templates.h"
#include "core/math/lanes.h"

namespace marey {
namespace {

bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

}  // namespace

const BlockKernels& block_kernels() {
  static const BlockKernels kernels = has_avx2() && block_kernels_detail::avx2() != nullptr
                                          ? *block_kernels_detail::avx2()
                                          : block_kernels_detail::kKernels<Lanes, LaneBits>;
  return kernels;
}

}  // namespace marey
