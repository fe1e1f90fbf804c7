// Registers the actions of the message list as commands.
#pragma once

#include "widgets/commands/command_registry.h"
#include "widgets/messages/message_list.h"

namespace usar::widgets {

/// Gives each action an id ("messages.copy") and its keys; texts and help are those of the actions.
void adoptMessageActions(CommandRegistry& commands, const MessageActions& actions);

} // namespace usar::widgets
