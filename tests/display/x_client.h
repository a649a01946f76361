// SPDX-License-Identifier: MIT
// Another client of the display, which does to a window what a person and a window manager do.
#pragma once

#include <memory>
#include <string>

namespace stagelight {

class XClient {
public:
    // Finds the window with that title. Throws std::runtime_error when there is none.
    explicit XClient(const std::string &title);
    ~XClient();
    XClient(const XClient &) = delete;
    XClient &operator=(const XClient &) = delete;

    // `key` by its name in X11: "w", "space", "Escape".
    void press(const std::string &key);
    void release(const std::string &key);
    void press_button(unsigned number);  // 1 left; 4 and 5 are a notch of the wheel, up and down
    void release_button(unsigned number);
    void move_mouse(int x, int y);  // pixels from the window's upper left corner
    void click_close();
    void resize(int width, int height);
    void minimise();
    void restore();
    void expose();
    std::string title() const;

private:
    struct Connection;
    std::unique_ptr<Connection> connection_;
};

}  // namespace stagelight
