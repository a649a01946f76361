// SPDX-License-Identifier: MIT
// OpenGL's functions through epoxy, then GLFW, which must not bring OpenGL's own headers.
#pragma once

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
