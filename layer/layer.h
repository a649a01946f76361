// SPDX-License-Identifier: MIT
// The parts of the layer: each puts its functions into the table that the loader calls.
#pragma once

#include <CL/cl_icd.h>

namespace stagelight {

// Whether cl_khr_gl_event is offered: not when STAGELIGHT_LAYER_GL_EVENT is 0, so that a program's
// way with glFinish can be tested.
bool offers_gl_event();

void install_devices(cl_icd_dispatch &table);
void install_contexts(cl_icd_dispatch &table);
void install_objects(cl_icd_dispatch &table);
void install_object_info(cl_icd_dispatch &table);
void install_derived_objects(cl_icd_dispatch &table);
void install_transfers(cl_icd_dispatch &table);
void install_events(cl_icd_dispatch &table);
void install_kernels(cl_icd_dispatch &table);
void install_commands(cl_icd_dispatch &table);

}  // namespace stagelight
