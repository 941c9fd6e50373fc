// Which item each invocation of a workgroup takes: by how much there is to do for it, for invocations that run together wait for
// the one that has most.

const uint kWorkClasses = 16u;
const float kClassesPerDoubling = 1.5;

shared uint classCounts[kWorkClasses];
shared uint itemInOrder[BAKE_GROUP_SIZE];

// The first where it is not known how much.
uint classOf(float work) {
    float doublings = work > 1.0 ? log2(work) : 0.0;
    return uint(min(kClassesPerDoubling * doublings, float(kWorkClasses - 1u)));
}

// For every invocation of the group, before any of them ends: of its own item there is so much to do. The number of another.
uint inOrderOf(float work) {
    uint self = gl_LocalInvocationIndex;
    if (self < kWorkClasses) {
        classCounts[self] = 0u;
    }
    barrier();
    uint ownClass = classOf(work);
    uint place = atomicAdd(classCounts[ownClass], 1u);
    barrier();
    for (uint i = 0u; i < kWorkClasses; ++i) {
        place += i < ownClass ? classCounts[i] : 0u;
    }
    itemInOrder[place] = self;
    barrier();
    return gl_WorkGroupID.x * BAKE_GROUP_SIZE + itemInOrder[self];
}
