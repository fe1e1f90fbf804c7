#include "core/protocol/generic_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

namespace {

/// Longer lists are summarized.
constexpr std::size_t longest_list = 16;

bool opensGroup(std::string_view key) {
    static constexpr std::array<std::string_view, 5> keys = {"Link", "ID", "PartName", "Object", "WheelNumber"};
    return std::ranges::any_of(keys, [key](std::string_view k) { return sameWord(k, key); }) ||
           sameWord(key.substr(0, 8), "Viewport");
}

/// All numbers of a comma-separated list; nullopt if an element is not a number.
std::optional<std::vector<double>> numbersOf(std::string_view value) {
    std::vector<double> numbers;
    value = trimmed(value);
    if (value.ends_with(','))
        value.remove_suffix(1);
    while (true) {
        const std::size_t comma = value.find(',');
        const std::optional<double> number = readNumber(value.substr(0, comma));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        if (comma == std::string_view::npos)
            return numbers;
        value.remove_prefix(comma + 1);
    }
}

class GenericCollector {
public:
    explicit GenericCollector(const GenericMessage& message)
        : source_(message.type.empty() ? message.type_word : message.type_word + " " + message.type) {}

    void take(std::string_view key, std::string_view value) {
        if (sameWord(key, "Type") || sameWord(key, "Time"))
            return;
        if (sameWord(key, "Name")) {
            takeName(value);
            return;
        }
        if (opensGroup(key))
            item_ = (name_.empty() ? "" : name_ + " ") + std::string(key) + " " + std::string(value);
        takeValue(std::string(key), value);
    }

    std::vector<Field> finish() { return std::move(fields_); }

private:
    void takeName(std::string_view value) {
        NamedPairs pairs(value);
        name_ = item_ = std::string(pairs.name());
        std::string_view key;
        std::string_view pair_value;
        while (pairs.next(key, pair_value))
            takeValue(std::string(key), pair_value);
    }

    void takeValue(const std::string& field, std::string_view value) {
        const std::optional<std::vector<double>> numbers = numbersOf(value);
        if (!numbers)
            fields_.push_back({source_, item_, field, std::nullopt, std::string(value), {}});
        else if (numbers->size() == 1)
            number(field, numbers->front());
        else if (numbers->size() > longest_list)
            summary(field, *numbers);
        else
            vector(field, *numbers);
    }

    void number(const std::string& field, double value) {
        const bool finite = std::isfinite(value);
        fields_.push_back(
            {source_, item_, field, finite ? std::optional(value) : std::nullopt, finite ? "" : "nan", {}});
    }

    void vector(const std::string& field, const std::vector<double>& numbers) {
        static constexpr std::array axes = {"x", "y", "z"};
        static constexpr std::array angles = {"roll", "pitch", "yaw"};
        const bool turned = sameWord(field, "Orientation") || sameWord(field, "Rotation");
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::string part = numbers.size() != 3 ? std::to_string(i) : turned ? angles[i] : axes[i];
            number(field + "." + part, numbers[i]);
        }
    }

    void summary(const std::string& field, const std::vector<double>& numbers) {
        const ListSummary summed = summaryOf(numbers);
        number(field + ".count", static_cast<double>(numbers.size()));
        number(field + ".minimum", summed.minimum);
        number(field + ".mean", summed.mean);
        number(field + ".maximum", summed.maximum);
    }

    std::string source_;
    std::string name_;
    std::string item_;
    std::vector<Field> fields_;
};

} // namespace

std::vector<Field> genericFieldsOf(const GenericMessage& message) {
    GenericCollector collector(message);
    for (const KeyValue& segment : message.segments)
        collector.take(segment.key, segment.value);
    return collector.finish();
}

ListSummary summaryOf(std::span<const double> values) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ListSummary summary{infinity, 0.0, -infinity};
    std::size_t count = 0;
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        summary.minimum = std::min(summary.minimum, value);
        summary.maximum = std::max(summary.maximum, value);
        summary.mean += value;
        ++count;
    }
    if (count == 0) {
        constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
        return {not_a_number, not_a_number, not_a_number};
    }
    summary.mean /= static_cast<double>(count);
    return summary;
}

} // namespace usar::protocol
