// SPDX-License-Identifier: MIT
// A TOML table read key by key. What is not as expected becomes a UserError that
// points at it: "file:line:column: what is wrong, what was expected".
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <toml++/toml.h>

#include "scene/scene.h"
#include "scene/validators.h"

namespace stagelight {

class TableReader {
public:
    // The table must outlive the reader. `name` is what messages call it.
    TableReader(const toml::table &table, std::string name, SourceLocation where);

    const SourceLocation &where() const { return where_; }
    // Where the value of `key` is; the table itself if it has no such key.
    SourceLocation where(std::string_view key) const;
    bool has(std::string_view key) const { return table_->contains(key); }
    bool has_array(std::string_view key) const { return (*table_)[key].is_array(); }

    void refuse_unknown(const std::vector<std::string_view> &known) const;
    // Refuses `key` in a table of type `type` unless that is one of `types`.
    void refuse_unless(std::initializer_list<std::string_view> types, std::string_view type,
                       std::string_view key) const;

    // Without a fallback the key is required.
    double number(std::string_view key, const Validator &validator,
                  std::optional<double> fallback = {}) const;
    std::vector<double> numbers(std::string_view key, std::size_t count,
                                const Validator &validator) const;
    glm::dvec3 vector(std::string_view key, const Validator &validator,
                      std::optional<glm::dvec3> fallback = {}) const;
    // Not zero, made unit length.
    glm::dvec3 direction(std::string_view key, std::optional<glm::dvec3> fallback = {}) const;
    std::string text(std::string_view key) const;
    // One of `names`, required.
    std::string choice(std::string_view key, const std::vector<std::string_view> &names) const;
    // Two of them, or one that stands for both, required.
    std::array<std::string, 2> two_choices(std::string_view key,
                                           const std::vector<std::string_view> &names) const;

    // A sub-table; an empty one if there is none.
    TableReader table(std::string_view key) const;
    // Every entry is a table: [key.NAME].
    std::vector<std::pair<std::string, TableReader>> named_tables(std::string_view key) const;
    // [[key]]
    std::vector<TableReader> array_of_tables(std::string_view key) const;

private:
    const toml::node &required(std::string_view key, std::string_view expected) const;
    double checked_number(const toml::node &node, std::string_view what,
                          const Validator &validator) const;
    TableReader reader_of(const toml::node &node, std::string_view what, std::string name) const;
    SourceLocation located(const toml::source_region &region) const;
    [[noreturn]] void fail(const toml::node &node, std::string_view what,
                           std::string_view expected) const;

    const toml::table *table_;
    std::string name_;
    SourceLocation where_;
};

}  // namespace stagelight
