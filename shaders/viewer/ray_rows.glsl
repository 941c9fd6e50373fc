// A ray's state as it lies in memory, in rows of four words: RayState's members in their order.

const int kRowsPerRay = 9;
// The first rows of what changes together.
const int kCourseRow = 3;     // when to look ahead, and what has been met; below it what every step changes
const int kMatterRow = 4;     // optical depth and transmittance
const int kSeenRow = 6;       // radiance, and the first throughput
const int kCrossingRow = 7;   // of a boundary, or the surface at the ray's end

struct RayRows {
    uvec4 row[kRowsPerRay];
};

uvec4 rowOf(vec3 first, float last) {
    return uvec4(floatBitsToUint(first), floatBitsToUint(last));
}

uvec4 rowOf(vec3 first, uint last) {
    return uvec4(floatBitsToUint(first), last);
}

RayRows rowsOf(RayState ray) {
    RayRows rows;
    rows.row[0] = rowOf(ray.x, ray.pathLength);
    rows.row[1] = rowOf(ray.w, ray.opticalLength);
    rows.row[2] = uvec4(floatBitsToUint(ray.n), ray.status, ray.evaluations, ray.lookUps);
    rows.row[3] = uvec4(floatBitsToUint(ray.lookAgainAt), ray.matterSamples, ray.dispersed, ray.generation);
    rows.row[4] = rowOf(ray.depth, ray.nCamera);
    rows.row[5] = rowOf(ray.transmittance, ray.entryDistance);
    rows.row[6] = rowOf(ray.radiance, ray.throughputS);
    rows.row[7] = rowOf(ray.crossingNormal, ray.throughputP);
    rows.row[8] = rowOf(vec3(ray.crossingGradMax, ray.crossingStart, ray.crossingWeight), ray.crossingAlong);
    return rows;
}

vec3 vectorOf(uvec4 row) {
    return uintBitsToFloat(uvec3(row));
}

RayState rayOf(RayRows rows) {
    RayState ray;
    ray.x = vectorOf(rows.row[0]);
    ray.pathLength = uintBitsToFloat(rows.row[0].w);
    ray.w = vectorOf(rows.row[1]);
    ray.opticalLength = uintBitsToFloat(rows.row[1].w);
    ray.n = uintBitsToFloat(rows.row[2].x);
    ray.status = rows.row[2].y;
    ray.evaluations = rows.row[2].z;
    ray.lookUps = rows.row[2].w;
    ray.lookAgainAt = uintBitsToFloat(rows.row[3].x);
    ray.matterSamples = rows.row[3].y;
    ray.dispersed = rows.row[3].z;
    ray.generation = rows.row[3].w;
    ray.depth = vectorOf(rows.row[4]);
    ray.nCamera = uintBitsToFloat(rows.row[4].w);
    ray.transmittance = vectorOf(rows.row[5]);
    ray.entryDistance = uintBitsToFloat(rows.row[5].w);
    ray.radiance = vectorOf(rows.row[6]);
    ray.throughputS = uintBitsToFloat(rows.row[6].w);
    ray.crossingNormal = vectorOf(rows.row[7]);
    ray.throughputP = uintBitsToFloat(rows.row[7].w);
    ray.crossingGradMax = uintBitsToFloat(rows.row[8].x);
    ray.crossingStart = uintBitsToFloat(rows.row[8].y);
    ray.crossingWeight = uintBitsToFloat(rows.row[8].z);
    ray.crossingAlong = uintBitsToFloat(rows.row[8].w);
    return ray;
}
