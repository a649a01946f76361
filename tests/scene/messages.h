// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/errors.h"

namespace stagelight {

// What the UserError says that `action` throws; "" if it throws none.
template <typename Action> std::string message_of(const Action &action) {
    try {
        action();
    } catch (const UserError &error) {
        return error.what();
    }
    return "";
}

}  // namespace stagelight
