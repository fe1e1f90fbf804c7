// The message inspector: its commands, what it sends, and what it remembers.
#pragma once

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"

namespace usar::app {

/// Lists the lines of the selected robot's connection, or of the one that waits for a robot, and sends typed commands
/// there. GUI thread.
class MessageDesk : public QObject {
    Q_OBJECT
public:
    explicit MessageDesk(const DeskContext& context) : desk_(context) {}

    void registerCommands();
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    void wireList();
    void raiseDock();
    /// Another robot is selected, or its connection changed.
    void followConnection();
    void chooseWhereToSave();
    void sendTyped(const QString& line);
    void sendAgain(int connection, const QStringList& lines);

    DeskContext desk_;
};

} // namespace usar::app
