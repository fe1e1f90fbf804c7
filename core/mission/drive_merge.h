// What a newer DRIVE leaves of an older one that was not sent yet, because a server would have kept it.
#pragma once

#include "core/protocol/command.h"

namespace usar::mission {

/// Whether the newer one takes the older one's place: both are of a kind, and of one joint where they name one.
bool replaces(const protocol::Command& newer, const protocol::Command& older);

/// Terms that `newer`, of the same kind, leaves out are taken from `older`; wheels and joints one by one. Relative
/// orders to a joint add up. Per cent and physical units do not mix: then `newer` stands alone.
void keepAbsentTerms(protocol::Command& newer, const protocol::Command& older);

/// Takes out of `older`, of another kind, what `newer` says about the same thing (lights, a joint), so that it does not
/// matter in which order they are sent. False when nothing is left of it.
bool takeOutWhatIsOld(protocol::Command& older, const protocol::Command& newer);

} // namespace usar::mission
