// Merging of a newer DRIVE with an older one that has not been sent yet, so that the server ends up in the same state
// as if it had received both.
#pragma once

#include "core/protocol/command.h"

namespace usar::mission {

/// True if `newer` can be sent instead of `older`: both are of the same kind and, for a joint, move the same one.
bool replaces(const protocol::Command& newer, const protocol::Command& older);

/// Completes `newer` with the terms that it leaves out from `older`, which must be of the same kind; wheels and joints
/// one by one. Relative orders to a joint add up. Percent and physical units do not mix: then `newer` keeps only its
/// own terms, plus the switches (lights, flip) of `older`.
void keepAbsentTerms(protocol::Command& newer, const protocol::Command& older);

/// Removes from `older`, of another kind, what `newer` sets as well (lights, a joint), so that the order in which they
/// are sent does not matter. Returns false if nothing of `older` is left.
bool takeOutWhatIsOld(protocol::Command& older, const protocol::Command& newer);

} // namespace usar::mission
