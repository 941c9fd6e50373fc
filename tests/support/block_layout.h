#pragma once
// Where the shading language puts the members of a block, asked of a linked program, and where this compiler puts them.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "common/gpu/objects.h"

/// A row of Members: a member of a struct and its offset.
#define EIKONAL_MEMBER(Struct, name) {#name, offsetof(Struct, name)}

namespace eikonal::test {

using Members = std::map<std::string, std::size_t>;  ///< offset in bytes by name

struct BlockLayout {
    Members members;         ///< arrays by their first element, "name[0]"
    std::size_t bytes = 0;   ///< of the block; an array without a size counts as one element
    std::size_t stride = 0;  ///< of the array that the block ends with; 0: none
};

/// Throws std::logic_error for a block that the kernel does not have.
BlockLayout uniformBlockLayout(const gpu::Kernel& kernel, const std::string& block);
BlockLayout storageBlockLayout(const gpu::Kernel& kernel, const std::string& block);

/// The same members as those of a struct that is itself a member: with a prefix to the names, after `offset` bytes.
Members prefixed(std::string_view prefix, const Members& members, std::size_t offset = 0);

} // namespace eikonal::test
