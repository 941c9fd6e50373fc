// The settings of a bake, which every kernel of it reads.
#include "shared/bake_blocks.h"

layout(std140, binding = BAKE_SETTINGS_BINDING) uniform SettingsBlock {
    BakeSettings settings;
};
