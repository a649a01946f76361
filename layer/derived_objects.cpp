// SPDX-License-Identifier: MIT
// What is made from a shared object is its memory too, and not to be used unless that is acquired.
#include "driver.h"
#include "layer.h"
#include "objects.h"

namespace stagelight {
namespace {

cl_mem inheriting(cl_mem made, cl_mem from) {
    const auto record = objects.find(from);
    if (record != nullptr) {
        remember(made, record);
    }
    return made;
}

cl_mem CL_API_CALL create_sub_buffer(cl_mem from, cl_mem_flags flags, cl_buffer_create_type type,
                                     const void *info, cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        return inheriting(made_by(driver->clCreateSubBuffer, from, flags, type, info), from);
    });
}

cl_mem CL_API_CALL create_image(cl_context context, cl_mem_flags flags,
                                const cl_image_format *format, const cl_image_desc *desc,
                                void *host, cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        const cl_mem made = made_by(driver->clCreateImage, context, flags, format, desc, host);
        return inheriting(made, desc->buffer);
    });
}

cl_mem CL_API_CALL create_image_with_properties(cl_context context,
                                                const cl_mem_properties *properties,
                                                cl_mem_flags flags, const cl_image_format *format,
                                                const cl_image_desc *desc, void *host,
                                                cl_int *errcode_ret) {
    return answer_handle(errcode_ret, [&] {
        const cl_mem made = made_by(driver->clCreateImageWithProperties, context, properties, flags,
                                    format, desc, host);
        return inheriting(made, desc->buffer);
    });
}

}  // namespace

void install_derived_objects(cl_icd_dispatch &table) {
    table.clCreateSubBuffer = create_sub_buffer;
    table.clCreateImage = create_image;
    table.clCreateImageWithProperties = create_image_with_properties;
}

}  // namespace stagelight
