#pragma once
// A buffer that kernels write by rows of words and read as texels, which takes the software renderer a tenth of the time that it
// takes to read storage.

#include "common/gpu/objects.h"

namespace eikonal::gpu {

class RowBuffer : public Buffer {
public:
    /// Rows of 1, 2 or 4 words of four bytes. Throws badInput if there are more rows than the device has texels for.
    RowBuffer(const Context& context, std::size_t bytes, std::string_view label, int wordsPerRow = 4);
    RowBuffer(RowBuffer&& other) noexcept;
    RowBuffer& operator=(RowBuffer&& other) noexcept;
    ~RowBuffer();

    /// See Buffer. Throws as the constructor does.
    void grow(std::size_t bytes);
    /// For kernels that read it.
    void bindTexels(GLuint unit) const;

private:
    int wordsPerRow_;
    GLuint texels_ = 0;
};

} // namespace eikonal::gpu
