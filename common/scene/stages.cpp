// SPDX-License-Identifier: MIT
#include "scene/stages.h"

namespace stagelight {

const std::vector<std::string> &stage_names() {
    static const std::vector<std::string> names{STAGELIGHT_STAGES};
    return names;
}

const std::string &stage_name(int number) {
    return stage_names().at(static_cast<std::size_t>(number - 1));
}

}  // namespace stagelight
