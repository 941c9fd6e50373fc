// The order in which a tile's pixels are listed. Rays of a block, and of a vector of a device, go much the same way. Pieces of the
// picture follow each other as the golden section has it, so that every stretch of the list has some of all its parts and as
// much work as another: the software renderer deals the workgroups of a dispatch out to its threads in as many stretches.
#include "gpu/division.glsl"
#include "shared/view_blocks.h"

// Neighbours in Fibonacci's series: multiples of one, taken modulo the other, lie as evenly as numbers can.
const uint kPieceStride = 55u;

// The block at a place of the order, counted row after row; perhaps beyond the last one.
uint blockAtPlace(uint place, uint blocks) {
    uint blocksPerPiece = (blocks + uint(kPicturePieces) - 1u) / uint(kPicturePieces);
    uvec2 pieceAndBlock = divided(place, blocksPerPiece);
    if (pieceAndBlock.x >= uint(kPicturePieces)) {
        return blocks;
    }
    return pieceAndBlock.x * kPieceStride % uint(kPicturePieces) * blocksPerPiece + pieceAndBlock.y;
}

// Within the block: eight that follow each other are four columns of two rows.
uvec2 pixelInBlock(uint i) {
    return uvec2((i & 3u) | ((i >> 3) & 1u) << 2, ((i >> 2) & 1u) | ((i >> 4) & 3u) << 1);
}

// The ray of pixel i of the block at a place of the order, or `none`.
uint rayInPictureOrder(uint place, uint i, uint none) {
    uvec2 size = uvec2(view.tileSize);
    uvec2 blocks = (size + uint(kBlockEdge) - 1u) / uint(kBlockEdge);
    uint block = blockAtPlace(place, blocks.x * blocks.y);
    uvec2 pixel = divided(block, blocks.x).yx * uint(kBlockEdge) + pixelInBlock(i);
    return all(lessThan(pixel, size)) ? pixel.y * size.x + pixel.x : none;
}
