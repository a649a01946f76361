// SPDX-License-Identifier: MIT
#include "display/x_client.h"

#include <array>
#include <stdexcept>

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace stagelight {

struct XClient::Connection {
    Display *display = nullptr;
    Window window = 0;
    Time time = 1;  // of the next event: GLFW leaves out what isn't newer than the last

    std::string title_of(Window of) const {
        std::string title;
        char *text = nullptr;
        if (XFetchName(display, of, &text) && text) {
            title = text;
            XFree(text);
        }
        return title;
    }

    Window find(const std::string &title) const {
        Window root = 0;
        Window parent = 0;
        Window *children = nullptr;
        unsigned count = 0;
        Window found = 0;
        XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
        for (unsigned i = 0; i < count; ++i) {
            found = title_of(children[i]) == title ? children[i] : found;
        }
        XFree(children);
        return found;
    }

    void send(XEvent event, long mask) {
        event.xany.display = display;
        event.xany.window = window;
        XSendEvent(display, window, False, mask, &event);
        XSync(display, False);
    }

    void send_key(const std::string &key, int type) {
        XEvent event{};
        event.xkey.type = type;
        event.xkey.time = time++;
        event.xkey.keycode = XKeysymToKeycode(display, XStringToKeysym(key.c_str()));
        if (event.xkey.keycode == 0) {
            throw std::runtime_error("no key " + key);
        }
        send(event, KeyPressMask | KeyReleaseMask);
    }

    void send_button(unsigned number, int type) {
        XEvent event{};
        event.xbutton.type = type;
        event.xbutton.time = time++;
        event.xbutton.button = number;
        send(event, ButtonPressMask | ButtonReleaseMask);
    }

    // What a window manager leaves at the window (ICCCM, section 4.1.3.1).
    void set_state(long state) {
        const Atom property = XInternAtom(display, "WM_STATE", False);
        const std::array<long, 2> value = {state, None};
        XChangeProperty(display, window, property, property, 32, PropModeReplace,
                        reinterpret_cast<const unsigned char *>(value.data()), 2);
        XSync(display, False);
    }
};

XClient::XClient(const std::string &title) : connection_(std::make_unique<Connection>()) {
    connection_->display = XOpenDisplay(nullptr);
    connection_->window = connection_->display ? connection_->find(title) : 0;
    if (!connection_->window) {
        throw std::runtime_error("no window " + title);
    }
}

XClient::~XClient() {
    XCloseDisplay(connection_->display);
}

void XClient::press(const std::string &key) {
    connection_->send_key(key, KeyPress);
}
void XClient::release(const std::string &key) {
    connection_->send_key(key, KeyRelease);
}
void XClient::press_button(unsigned number) {
    connection_->send_button(number, ButtonPress);
}
void XClient::release_button(unsigned number) {
    connection_->send_button(number, ButtonRelease);
}

// Truly, unlike the other events: GLFW puts the pointer back while it is held, and must see that.
void XClient::move_mouse(int x, int y) {
    XWarpPointer(connection_->display, None, connection_->window, 0, 0, 0, 0, x, y);
    XSync(connection_->display, False);
}

void XClient::click_close() {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.message_type = XInternAtom(connection_->display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = long(XInternAtom(connection_->display, "WM_DELETE_WINDOW", False));
    connection_->send(event, NoEventMask);
}

void XClient::resize(int width, int height) {
    XResizeWindow(connection_->display, connection_->window, unsigned(width), unsigned(height));
    XSync(connection_->display, False);
}

void XClient::minimise() {
    XUnmapWindow(connection_->display, connection_->window);
    connection_->set_state(IconicState);
}

void XClient::restore() {
    XMapWindow(connection_->display, connection_->window);
    connection_->set_state(NormalState);
}

void XClient::expose() {
    XEvent event{};
    event.xexpose.type = Expose;
    connection_->send(event, ExposureMask);
}

std::string XClient::title() const {
    return connection_->title_of(connection_->window);
}

}  // namespace stagelight
