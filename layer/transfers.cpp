// SPDX-License-Identifier: MIT
// Acquire and release, which copy: OpenCL Extension Specification, cl_khr_gl_sharing, "Sharing
// memory objects that map to GL objects between GL and CL contexts".
#include <vector>

#include <CL/cl_gl.h>
#include <epoxy/gl.h>

#include "driver.h"
#include "layer.h"
#include "objects.h"
#include "transfer_events.h"

namespace stagelight {
namespace {

using Objects = std::vector<std::shared_ptr<SharedObject>>;

constexpr std::size_t origin[3] = {0, 0, 0};

cl_int enqueue_write(cl_command_queue queue, const SharedObject &of, const GlBuffer &gl,
                     const WaitList &after, cl_event *event) {
    return driver->clEnqueueWriteBuffer(queue, of.handle, CL_FALSE, 0, gl.bytes(),
                                        of.staging.data(), after.count, after.events, event);
}

template <typename GlImage>
cl_int enqueue_write(cl_command_queue queue, const SharedObject &of, const GlImage &gl,
                     const WaitList &after, cl_event *event) {
    return driver->clEnqueueWriteImage(queue, of.handle, CL_FALSE, origin, gl.region().data(), 0, 0,
                                       of.staging.data(), after.count, after.events, event);
}

cl_int enqueue_read(cl_command_queue queue, SharedObject &of, const GlBuffer &gl,
                    const WaitList &after, cl_event *event) {
    return driver->clEnqueueReadBuffer(queue, of.handle, CL_FALSE, 0, gl.bytes(), of.staging.data(),
                                       after.count, after.events, event);
}

template <typename GlImage>
cl_int enqueue_read(cl_command_queue queue, SharedObject &of, const GlImage &gl,
                    const WaitList &after, cl_event *event) {
    return driver->clEnqueueReadImage(queue, of.handle, CL_FALSE, origin, gl.region().data(), 0, 0,
                                      of.staging.data(), after.count, after.events, event);
}

// The objects of a call, with the errors that acquire and release have in common. OpenGL can be
// asked of them afterwards.
Objects checked(cl_context context, cl_uint count, const cl_mem *handles) {
    Objects all;
    for (cl_uint i = 0; i < count; ++i) {
        context_of(handles[i]);  // CL_INVALID_MEM_OBJECT, from the driver
        all.push_back(made_from_gl(handles[i]));
        require(all.back()->context->handle == context, CL_INVALID_CONTEXT,
                "the command queue is of another context than the shared object");
    }
    all.front()->context->gl->require_current();
    for (const auto &each : all) {
        std::visit([](const auto &gl) { gl.require_unchanged(); }, each->gl);
    }
    return all;
}

// All objects change hands or none does: two threads cannot acquire the same one.
class ChangeOfHands {
public:
    // Throws Refusal CL_INVALID_OPERATION when one already is where it shall go.
    ChangeOfHands(const Objects &all, bool to_opencl) : to_opencl_(to_opencl) {
        for (const auto &each : all) {
            if (each->acquired.exchange(to_opencl) == to_opencl) {
                undo();
                refuse(CL_INVALID_OPERATION, "%s is %s", each->name().c_str(),
                       to_opencl ? "acquired already" : "released but was not acquired");
            }
            changed_.push_back(each);
        }
    }
    ~ChangeOfHands() { undo(); }
    ChangeOfHands(const ChangeOfHands &) = delete;
    ChangeOfHands &operator=(const ChangeOfHands &) = delete;

    void keep() { changed_.clear(); }

private:
    void undo() {
        for (const auto &each : changed_) {
            each->acquired = !to_opencl_;
        }
    }

    bool to_opencl_;
    Objects changed_;
};

void acquire(cl_command_queue queue, const Objects &all, const WaitList &after, cl_event *event) {
    ChangeOfHands change(all, true);
    after.wait();  // OpenGL may still be drawing, in another thread, what is copied here
    TransferEvents written;
    for (const auto &each : all) {
        const auto copy = [&](const auto &gl) {
            gl.read(each->staging.data());
            require(enqueue_write(queue, *each, gl, after, written.next()));
        };
        std::visit(copy, each->gl);
    }
    written.give(queue, CL_COMMAND_ACQUIRE_GL_OBJECTS, event);
    change.keep();
}

void release(cl_command_queue queue, const Objects &all, const WaitList &after, cl_event *event) {
    after.require_no_gl_sync();
    ChangeOfHands change(all, false);
    TransferEvents read;
    for (const auto &each : all) {
        const auto copy = [&](const auto &gl) {
            require(enqueue_read(queue, *each, gl, after, read.next()));
        };
        std::visit(copy, each->gl);
    }
    read.wait();
    for (const auto &each : all) {
        std::visit([&](const auto &gl) { gl.write(each->staging.data()); }, each->gl);
    }
    glFinish();  // a program that waited for the event may use the object in another context
    read.give(queue, CL_COMMAND_RELEASE_GL_OBJECTS, event);
    change.keep();
}

template <auto Driver, auto Transfer>
cl_int CL_API_CALL enqueue(cl_command_queue queue, cl_uint count, const cl_mem *handles,
                           cl_uint wait_count, const cl_event *wait_events, cl_event *event) {
    return answer([&] {
        const bool ours = count > 0 && handles != nullptr && objects.find(handles[0]) != nullptr;
        const cl_context context = context_of(queue);
        if (!ours && belongs_to_driver(context)) {
            return require(
                (driver->*Driver)(queue, count, handles, wait_count, wait_events, event));
        }
        if (!ours) {
            sharing_context(context);
        }
        require((count == 0) == (handles == nullptr), CL_INVALID_VALUE,
                "the number of objects does not fit their list");
        const WaitList after(wait_count, wait_events);
        if (count > 0) {
            Transfer(queue, checked(context, count, handles), after, event);
        }
    });
}

}  // namespace

void install_transfers(cl_icd_dispatch &table) {
    table.clEnqueueAcquireGLObjects = enqueue<&cl_icd_dispatch::clEnqueueAcquireGLObjects, acquire>;
    table.clEnqueueReleaseGLObjects = enqueue<&cl_icd_dispatch::clEnqueueReleaseGLObjects, release>;
}

}  // namespace stagelight
