#include "core/protocol/info/answers.h"

#include "core/protocol/segments.h"

namespace usar::protocol {

std::optional<double> ConfiguredItem::number(const std::string& key) const {
    for (const Setting& setting : settings) {
        if (setting.number && sameWord(setting.key, key))
            return setting.number;
    }
    return std::nullopt;
}

} // namespace usar::protocol
