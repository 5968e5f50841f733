// Compiled for AVX2 where the target is x86-64 (core/CMakeLists.txt).
#include "core/kinematics/block_kernels.h"

#if defined(__AVX2__)
#include "core/kinematics/block_kernel_templates.h"
#include "core/math/lanes.h"
#endif

namespace marey::block_kernels_detail {

const BlockKernels* avx2() {
#if defined(__AVX2__)
  return &kKernels<WideLanes, WideLaneBits>;
#else
  return nullptr;
#endif
}

}  // namespace marey::block_kernels_detail
