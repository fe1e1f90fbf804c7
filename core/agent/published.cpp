#include "core/agent/published.h"

namespace usar::agent {

Published::Published() = default;
Published::Published(const Published& other) = default;
Published::Published(Published&& other) noexcept = default;
Published& Published::operator=(const Published& other) = default;
Published& Published::operator=(Published&& other) noexcept = default;
Published::~Published() = default;

bool Published::operator==(const Published& other) const {
    return static_cast<const PublishedVariant&>(*this) == static_cast<const PublishedVariant&>(other);
}

} // namespace usar::agent
