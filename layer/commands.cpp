// SPDX-License-Identifier: MIT
// Commands are refused that use a shared object before it is acquired, which the extension leaves
// undefined ("Synchronizing OpenCL and OpenGL Access to Shared Objects"), and commands that wait
// for the event of a GL sync (cl_khr_gl_event, section 5.11.1).
#include <tuple>
#include <type_traits>

#include "driver.h"
#include "kernels.h"
#include "layer.h"
#include "objects.h"
#include "transfer_events.h"

namespace stagelight {
namespace {

void require_acquired(const SharedObject &object) {
    if (!object.acquired) {
        refuse(CL_INVALID_GL_OBJECT, "an OpenCL command uses %s, which is not acquired",
               object.name().c_str());
    }
}

// Sees the arguments of a command one after the other. OpenCL puts the length before its list.
class Inspection {
public:
    void operator()(cl_mem handle) {
        const auto object = objects.find(handle);
        if (object != nullptr) {
            require_acquired(*object);
        }
    }

    void operator()(cl_kernel kernel) {
        const auto record = kernels.find(kernel);
        if (record == nullptr) {
            return;
        }
        for (const auto &[index, argument] : record->arguments) {
            const auto object = argument.lock();
            if (object != nullptr) {
                require_acquired(*object);
            }
        }
    }

    void operator()(cl_uint length) { length_ = length; }

    void operator()(const cl_mem *handles) {
        for (cl_uint i = 0; handles != nullptr && i < length_; ++i) {
            (*this)(handles[i]);
        }
    }

    void operator()(const cl_event *events) {
        if (events != nullptr) {
            WaitList(length_, events).require_no_gl_sync();
        }
    }

    template <typename Other> void operator()(Other) {}

private:
    cl_uint length_ = 0;
};

// The command of the driver's table, after an inspection of its arguments.
template <auto Command> struct Inspected;

template <typename Result, typename... Arguments, Result (*cl_icd_dispatch::*Command)(Arguments...)>
struct Inspected<Command> {
    static Result call(Arguments... arguments) noexcept {
        Inspection inspect;
        const cl_int code = answer([&] { (inspect(arguments), ...); });
        if (code == CL_SUCCESS) {
            return (driver->*Command)(arguments...);
        }
        if constexpr (std::is_pointer_v<Result>) {  // clEnqueueMap…: the code goes elsewhere
            cl_int *errcode_ret = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
            if (errcode_ret != nullptr) {
                *errcode_ret = code;
            }
            return nullptr;
        } else {
            return code;
        }
    }
};

template <auto... Commands> void inspect(cl_icd_dispatch &table) {
    ((table.*Commands = Inspected<Commands>::call), ...);
}

}  // namespace

void install_commands(cl_icd_dispatch &table) {
    using Of = cl_icd_dispatch;
    inspect<&Of::clEnqueueReadBuffer, &Of::clEnqueueReadBufferRect, &Of::clEnqueueReadImage,
            &Of::clEnqueueWriteBuffer, &Of::clEnqueueWriteBufferRect, &Of::clEnqueueWriteImage,
            &Of::clEnqueueCopyBuffer, &Of::clEnqueueCopyBufferRect, &Of::clEnqueueCopyImage,
            &Of::clEnqueueCopyImageToBuffer, &Of::clEnqueueCopyBufferToImage,
            &Of::clEnqueueFillBuffer, &Of::clEnqueueFillImage, &Of::clEnqueueMapBuffer,
            &Of::clEnqueueMapImage, &Of::clEnqueueUnmapMemObject, &Of::clEnqueueMigrateMemObjects,
            &Of::clEnqueueNDRangeKernel, &Of::clEnqueueTask, &Of::clEnqueueNativeKernel,
            &Of::clEnqueueMarkerWithWaitList, &Of::clEnqueueBarrierWithWaitList,
            &Of::clEnqueueWaitForEvents, &Of::clEnqueueSVMFree, &Of::clEnqueueSVMMemcpy,
            &Of::clEnqueueSVMMemFill, &Of::clEnqueueSVMMap, &Of::clEnqueueSVMUnmap,
            &Of::clEnqueueSVMMigrateMem>(table);
}

}  // namespace stagelight
