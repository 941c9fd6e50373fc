// The order in which a tile's pixels are listed. Rays of a block, and of a vector of a device, go much the same way. Pieces of the
// picture follow each other as the golden section has it, so that every stretch of the list has some of all its parts and as
// much work as another: the software renderer deals the workgroups of a dispatch out to its threads in as many stretches.
#include "shared/view_blocks.h"

// Neighbours in Fibonacci's series: multiples of one, taken modulo the other, lie as evenly as numbers can.
const uint kPieceStride = 55u;

// The workgroup's block, row after row; perhaps beyond the last one.
uint blockOfGroup(uint blocks) {
    uint blocksPerPiece = (blocks + uint(kPicturePieces) - 1u) / uint(kPicturePieces);
    uint piece = gl_WorkGroupID.x / blocksPerPiece;
    return piece * kPieceStride % uint(kPicturePieces) * blocksPerPiece + gl_WorkGroupID.x % blocksPerPiece;
}

// Within the block: eight that follow each other are four columns of two rows.
uvec2 pixelInBlock() {
    uint i = gl_LocalInvocationIndex;
    return uvec2((i & 3u) | ((i >> 3) & 1u) << 2, ((i >> 2) & 1u) | ((i >> 4) & 3u) << 1);
}

// The ray whose pixel is this invocation's, or `none`.
uint rayInPictureOrder(uint none) {
    uvec2 size = uvec2(view.tileSize);
    uvec2 blocks = (size + uint(kBlockEdge) - 1u) / uint(kBlockEdge);
    uint block = blockOfGroup(blocks.x * blocks.y);
    uvec2 pixel = uvec2(block % blocks.x, block / blocks.x) * uint(kBlockEdge) + pixelInBlock();
    return all(lessThan(pixel, size)) ? pixel.y * size.x + pixel.x : none;
}
