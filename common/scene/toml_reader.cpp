// SPDX-License-Identifier: MIT
#include "scene/toml_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/errors.h"
#include "scene/normalize.h"
#include "scene/suggest.h"

namespace stagelight {
namespace {

// A number is told by its value, anything else by its type.
std::string found(const toml::node &node) {
    switch (node.type()) {
    case toml::node_type::integer:
        return fmt::format("{}", node.as_integer()->get());
    case toml::node_type::floating_point:
        return fmt::format("{}", node.as_floating_point()->get());
    case toml::node_type::array:
        return fmt::format("an array of {}", node.as_array()->size());
    case toml::node_type::string:
        return "a string";
    case toml::node_type::boolean:
        return "a boolean";
    case toml::node_type::table:
        return "a table";
    default:
        return "a date or time";
    }
}

std::string words_for(std::size_t count) {
    return count == 2   ? "two numbers"
           : count == 3 ? "three numbers"
                        : fmt::format("{} numbers", count);
}

}  // namespace

TableReader::TableReader(const toml::table &table, std::string name, SourceLocation where)
    : table_(&table), name_(std::move(name)), where_(std::move(where)) {}

SourceLocation TableReader::located(const toml::source_region &region) const {
    return {where_.file, region.begin.line, region.begin.column};
}

SourceLocation TableReader::where(std::string_view key) const {
    const toml::node *node = table_->get(key);
    return node ? located(node->source()) : where_;
}

void TableReader::fail(const toml::node &node, std::string_view what,
                       std::string_view expected) const {
    throw UserError(fmt::format("{}: {} is {}, expected {}", to_string(located(node.source())),
                                what, found(node), expected));
}

const toml::node &TableReader::required(std::string_view key, std::string_view expected) const {
    if (const toml::node *node = table_->get(key)) {
        return *node;
    }
    throw UserError(
        fmt::format("{}: {} has no {}, expected {}", to_string(where_), name_, key, expected));
}

void TableReader::refuse_unknown(const std::vector<std::string_view> &known) const {
    for (const auto &[key, node] : *table_) {
        if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
            throw UserError(fmt::format("{}: unknown key '{}' in {}, {}",
                                        to_string(located(key.source())), key.str(), name_,
                                        suggest(key.str(), known)));
        }
    }
}

void TableReader::refuse_unless(std::initializer_list<std::string_view> types,
                                std::string_view type, std::string_view key) const {
    const auto entry = table_->find(key);
    if (entry != table_->end() && std::find(types.begin(), types.end(), type) == types.end()) {
        throw UserError(fmt::format("{}: {} in {}, which is {}: expected only with type {}",
                                    to_string(located(entry->first.source())), key, name_, type,
                                    fmt::join(types, ", ")));
    }
}

double TableReader::checked_number(const toml::node &node, std::string_view what,
                                   const Validator &validator) const {
    if (!node.is_number()) {
        fail(node, what, validator.words);
    }
    const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                           : node.as_floating_point()->get();
    if (!(std::abs(value) <= largest_number)) {
        fail(node, what, fmt::format("a finite number, at most {} in magnitude", largest_number));
    }
    if (!validator.holds(value)) {
        fail(node, what, validator.words);
    }
    return value;
}

double TableReader::number(std::string_view key, const Validator &validator,
                           std::optional<double> fallback) const {
    if (fallback && !has(key)) {
        return *fallback;
    }
    return checked_number(required(key, validator.words), key, validator);
}

std::vector<double> TableReader::numbers(std::string_view key, std::size_t count,
                                         const Validator &validator) const {
    const toml::node &node = required(key, words_for(count));
    const toml::array *array = node.as_array();
    if (!array || array->size() != count) {
        fail(node, key, words_for(count));
    }
    std::vector<double> values;
    for (const toml::node &element : *array) {
        values.push_back(
            checked_number(element, fmt::format("{}[{}]", key, values.size()), validator));
    }
    return values;
}

glm::dvec3 TableReader::vector(std::string_view key, const Validator &validator,
                               std::optional<glm::dvec3> fallback) const {
    if (fallback && !has(key)) {
        return *fallback;
    }
    const std::vector<double> values = numbers(key, 3, validator);
    return {values[0], values[1], values[2]};
}

glm::dvec3 TableReader::direction(std::string_view key, std::optional<glm::dvec3> fallback) const {
    const glm::dvec3 given = vector(key, any_number, fallback);
    if (given == glm::dvec3(0)) {
        throw UserError(fmt::format("{}: {} is zero, expected a vector with a direction",
                                    to_string(where(key)), key));
    }
    return normalize(given);
}

std::string TableReader::text(std::string_view key) const {
    const toml::node &node = required(key, "a string");
    if (!node.is_string()) {
        fail(node, key, "a string");
    }
    return node.as_string()->get();
}

std::string TableReader::choice(std::string_view key,
                                const std::vector<std::string_view> &names) const {
    required(key, fmt::format("one of {}", fmt::join(names, ", ")));
    std::string name = text(key);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw UserError(fmt::format("{}: unknown {} '{}', {}", to_string(where(key)), key, name,
                                    suggest(name, names)));
    }
    return name;
}

std::array<std::string, 2>
TableReader::two_choices(std::string_view key, const std::vector<std::string_view> &names) const {
    if (!has_array(key)) {
        const std::string name = choice(key, names);
        return {name, name};
    }
    const toml::array &array = *(*table_)[key].as_array();
    const std::string expected = fmt::format("one or two strings of {}", fmt::join(names, ", "));
    if (array.size() != 2) {
        fail(array, key, expected);
    }
    std::array<std::string, 2> chosen;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string what = fmt::format("{}[{}]", key, i);
        if (!array[i].is_string()) {
            fail(array[i], what, expected);
        }
        chosen[i] = array[i].as_string()->get();
        if (std::ranges::find(names, chosen[i]) == names.end()) {
            throw UserError(fmt::format("{}: unknown {} '{}', {}",
                                        to_string(located(array[i].source())), what, chosen[i],
                                        suggest(chosen[i], names)));
        }
    }
    return chosen;
}

TableReader TableReader::reader_of(const toml::node &node, std::string_view what,
                                   std::string name) const {
    if (!node.is_table()) {
        fail(node, what, fmt::format("a table, {}", name));
    }
    return {*node.as_table(), std::move(name), located(node.source())};
}

TableReader TableReader::table(std::string_view key) const {
    static const toml::table empty;
    std::string name = fmt::format("[{}]", key);
    const toml::node *node = table_->get(key);
    return node ? reader_of(*node, key, std::move(name)) : TableReader(empty, name, where_);
}

std::vector<std::pair<std::string, TableReader>>
TableReader::named_tables(std::string_view key) const {
    std::vector<std::pair<std::string, TableReader>> readers;
    for (const auto &[name, node] : *table(key).table_) {
        readers.emplace_back(name.str(),
                             reader_of(node, name.str(), fmt::format("[{}.{}]", key, name.str())));
    }
    return readers;
}

std::vector<TableReader> TableReader::array_of_tables(std::string_view key) const {
    std::vector<TableReader> readers;
    if (!has(key)) {
        return readers;
    }
    const toml::node &node = *table_->get(key);
    const std::string name = fmt::format("[[{}]]", key);
    if (!node.is_array()) {
        fail(node, key, fmt::format("an array of tables, {}", name));
    }
    for (const toml::node &element : *node.as_array()) {
        readers.push_back(reader_of(element, fmt::format("{}[{}]", key, readers.size()), name));
    }
    return readers;
}

}  // namespace stagelight
