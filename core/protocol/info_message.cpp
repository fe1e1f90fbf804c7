#include "core/protocol/info_message.h"

namespace usar::protocol {

InfoMessage::InfoMessage() = default;
InfoMessage::InfoMessage(const InfoMessage& other) = default;
InfoMessage::InfoMessage(InfoMessage&& other) noexcept = default;
InfoMessage& InfoMessage::operator=(const InfoMessage& other) = default;
InfoMessage& InfoMessage::operator=(InfoMessage&& other) noexcept = default;
InfoMessage::~InfoMessage() = default;

bool InfoMessage::operator==(const InfoMessage& other) const {
    return static_cast<const InfoVariant&>(*this) == static_cast<const InfoVariant&>(other);
}

} // namespace usar::protocol
