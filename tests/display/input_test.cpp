// SPDX-License-Identifier: MIT
#include <map>

#include "display/open_window.h"
#include "display/x_client.h"

namespace stagelight {
namespace {

class WindowInput : public OnDisplay {
protected:
    void SetUp() override { window->poll(); }  // what came with the opening

    XClient person{"Stagelight"};
};

const std::map<std::string, bool Input::*> held_keys = {
    {"w", &Input::forward}, {"s", &Input::back},   {"a", &Input::left},
    {"d", &Input::right},   {"space", &Input::up}, {"c", &Input::down},
};
const std::map<std::string, bool Input::*> pressed_keys = {
    {"r", &Input::reload}, {"p", &Input::screenshot}, {"F1", &Input::help}};

int count_set(const Input &input, const std::map<std::string, bool Input::*> &keys) {
    int count = 0;
    for (const auto &[key, member] : keys) {
        count += input.*member ? 1 : 0;
    }
    return count;
}

int count_set(const Input &input) {
    return count_set(input, held_keys) + count_set(input, pressed_keys);
}

TEST_F(WindowInput, HeldKeysStayUntilReleased) {
    for (const auto &[key, member] : held_keys) {
        person.press(key);
        for (int i = 0; i < 3; ++i) {
            const Input input = window->poll();
            EXPECT_TRUE(input.*member) << key;
            EXPECT_EQ(count_set(input), 1) << key;
        }
        person.release(key);
        window->poll();  // may still count the key as tapped
        EXPECT_EQ(count_set(window->poll()), 0) << key;
    }
}

TEST_F(WindowInput, TwoHeldKeysCountBoth) {
    person.press("w");
    person.press("d");
    const Input input = window->poll();
    EXPECT_TRUE(input.forward && input.right);
    EXPECT_EQ(count_set(input), 2);
}

TEST_F(WindowInput, ATapBetweenTwoCallsCountsOnce) {
    for (const auto &[key, member] : held_keys) {
        person.press(key);
        person.release(key);
        EXPECT_TRUE(window->poll().*member) << key;
        EXPECT_EQ(count_set(window->poll()), 0) << key;
    }
}

TEST_F(WindowInput, PressesCountOnce) {
    for (const auto &[key, member] : pressed_keys) {
        person.press(key);
        person.press(key);  // the keyboard repeats
        const Input input = window->poll();
        EXPECT_TRUE(input.*member) << key;
        EXPECT_EQ(count_set(input), 1) << key;
        person.press(key);
        EXPECT_EQ(count_set(window->poll()), 0) << key;
        person.release(key);
        person.press(key);
        EXPECT_TRUE(window->poll().*member) << key;
    }
}

TEST_F(WindowInput, OtherKeysDoNothing) {
    person.press("x");
    person.press("Return");
    EXPECT_EQ(count_set(window->poll()), 0);
    EXPECT_FALSE(window->closed());
}

TEST_F(WindowInput, DraggingLooksAround) {
    person.move_mouse(100, 100);
    person.move_mouse(150, 120);
    EXPECT_EQ(window->poll().look, glm::dvec2(0, 0)) << "no button is pressed";
    person.press_button(1);
    window->poll();  // and GLFW puts the pointer into the window's centre
    person.move_mouse(320 + 30, 192 - 20);
    EXPECT_EQ(window->poll().look, glm::dvec2(30, -20));
    EXPECT_EQ(window->poll().look, glm::dvec2(0, 0));
    person.release_button(1);
    window->poll();
    person.move_mouse(10, 10);
    EXPECT_EQ(window->poll().look, glm::dvec2(0, 0));
}

TEST_F(WindowInput, ADragIsNotStoppedByTheEdge) {
    person.move_mouse(600, 100);
    person.press_button(1);
    glm::dvec2 way = window->poll().look;
    for (int i = 0; i < 20; ++i) {
        window->framebuffer_size();  // the display answers once it has put the pointer back
        window->poll();              // GLFW reads no further while it has events to read
        person.move_mouse(320 + 200, 192);
        way += window->poll().look;
    }
    EXPECT_EQ(way.x, 20 * 200);
}

TEST_F(WindowInput, TheOtherButtonsDoNotLook) {
    person.move_mouse(100, 100);
    person.press_button(3);
    window->poll();
    person.move_mouse(120, 120);
    EXPECT_EQ(window->poll().look, glm::dvec2(0, 0));
}

TEST_F(WindowInput, ScrollAddsUp) {
    for (const unsigned button : {4U, 4U, 4U, 5U}) {
        person.press_button(button);
        person.release_button(button);
    }
    EXPECT_EQ(window->poll().scroll, 2);
    EXPECT_EQ(window->poll().scroll, 0);
}

TEST_F(WindowInput, EscapeCloses) {
    person.press("Escape");
    window->poll();
    EXPECT_TRUE(window->closed());
}

TEST_F(WindowInput, TheCloseButtonCloses) {
    person.click_close();
    window->poll();
    EXPECT_TRUE(window->closed());
}

TEST_F(WindowInput, TheProgramCloses) {
    window->close();
    EXPECT_TRUE(window->closed());
}

TEST_F(WindowInput, ResizingTellsTheNewSize) {
    person.resize(801, 479);
    EXPECT_TRUE(window->poll().resized);
    EXPECT_EQ(window->framebuffer_size(), glm::ivec2(801, 479));
    EXPECT_FALSE(window->poll().resized);
}

TEST_F(WindowInput, AMinimisedWindowHasNoPixels) {
    person.minimise();
    EXPECT_TRUE(window->poll().resized);
    EXPECT_EQ(window->framebuffer_size(), glm::ivec2(0, 0));
    person.restore();
    EXPECT_TRUE(window->poll().resized);
    EXPECT_EQ(window->framebuffer_size(), glm::ivec2(640, 384));
}

TEST_F(WindowInput, UncoveringAsksForARedraw) {
    EXPECT_FALSE(window->poll().needs_redraw);
    person.expose();
    EXPECT_TRUE(window->poll().needs_redraw);
    EXPECT_FALSE(window->poll().needs_redraw);
}

TEST_F(WindowInput, WaitEndsWithAnEventOrWithTheTime) {
    for (const double seconds : {0.01, 0.0, -1.0}) {
        EXPECT_EQ(count_set(window->wait(seconds)), 0);
    }
    person.press("r");
    EXPECT_TRUE(window->wait(60).reload);
}

}  // namespace
}  // namespace stagelight
