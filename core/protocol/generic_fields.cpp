#include "core/protocol/fields.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/field_list.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

namespace {

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
    GenericCollector(const GenericMessage& message, FieldList& fields) : fields_(fields) {
        fields_.source = message.type.empty() ? message.type_word : message.type_word + " " + message.type;
    }

    void take(std::string_view key, std::string_view value) {
        if (sameWord(key, "Type") || sameWord(key, "Time"))
            return;
        if (sameWord(key, "Name"))
            return takeName(value);
        if (opensGroup(key))
            fields_.item = (name_.empty() ? "" : name_ + " ") + std::string(key) + " " + std::string(value);
        takeValue(key, value);
    }

private:
    void takeName(std::string_view value) {
        NamedPairs pairs(value);
        name_ = fields_.item = std::string(pairs.name());
        std::string_view key;
        std::string_view pair_value;
        while (pairs.next(key, pair_value))
            takeValue(key, pair_value);
    }

    void takeValue(std::string_view field, std::string_view value) {
        const std::optional<std::vector<double>> numbers = numbersOf(value);
        if (!numbers)
            fields_.text(field, value);
        else if (numbers->size() == 1)
            fields_.number(field, numbers->front());
        else if (numbers->size() == 3)
            fields_.vector(field, Vec3(numbers->data()), {},
                           sameWord(field, "Orientation") || sameWord(field, "Rotation"));
        else
            fields_.values(field, *numbers, {});
    }

    std::string name_;
    FieldList& fields_;
};

} // namespace

std::vector<Field> genericFieldsOf(const GenericMessage& message) {
    FieldList fields;
    listGenericFields(message, fields);
    return fields.take();
}

void listGenericFields(const GenericMessage& message, FieldList& fields) {
    GenericCollector collector(message, fields);
    for (const KeyValue& segment : message.segments)
        collector.take(segment.key, segment.value);
}

} // namespace usar::protocol
