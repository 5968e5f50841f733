// One libFuzzer program; FUZZ_TARGET says which of the targets it is.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const marey::test::FuzzTarget& target : marey::test::kFuzzTargets) {
    if (target.name != FUZZ_TARGET) continue;
    const marey::test::Harm harm = target.find_harm({reinterpret_cast<const char*>(data), size});
    if (!harm) return 0;
    std::fprintf(stderr, "HARM: %s\n", harm->c_str());
    std::abort();
  }
  std::abort();
}
