// What libFuzzer calls with each input; EIKONAL_FUZZ_INTAKE names the function of intakes.h.

#include "tests/fuzz/intakes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    eikonal::fuzz::EIKONAL_FUZZ_INTAKE({data, size});
    return 0;
}
