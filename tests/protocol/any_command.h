// Random commands of every kind, for tests of what holds for all of them.
#pragma once

#include "core/base/random.h"
#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace any {

inline constexpr std::size_t kinds = std::variant_size_v<usar::protocol::CommandVariant>;

/// One of this alternative of Command that says something in that dialect; a raw one is a word that no reader knows.
usar::protocol::Command command(std::size_t kind, usar::protocol::Dialect dialect, usar::Random& random);

} // namespace any
