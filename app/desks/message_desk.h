// Desk of the messages dock: its commands, the lines that the user sends, and its settings.
#pragma once

#include "app/desks/desk.h"

namespace usar::app {

/// Chooses the connection whose lines are listed and to which typed commands are sent: that of the selected robot, or
/// without one the connection that waits for the next robot. GUI thread.
class MessageDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

private:
    /// Shows the right connection after another robot was selected or a connection has changed.
    void followConnection();
    void chooseWhereToSave();
    /// Sends a line from the command box; an error is shown there.
    void sendTyped(const QString& line);
    /// Sends lines unchanged on the connection that they were copied from, up to the first error.
    void sendAgain(ConnectionId connection, const QStringList& lines);
};

} // namespace usar::app
