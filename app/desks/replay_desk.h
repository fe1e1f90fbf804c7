// Recording and replay: commands, the bar below the hint, and the badge that says what is recorded.
#pragma once

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"

namespace usar::app {

/// Steers the replay that is selected. GUI thread.
class ReplayDesk : public QObject {
    Q_OBJECT
public:
    explicit ReplayDesk(const DeskContext& context) : desk_(context) {}

    void registerCommands();
    /// Once commands are registered.
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    /// Bar and badge of the selected robot.
    void show();
    void order(const mission::ReplayOrder& order);
    void setRecording(bool on);
    void chooseRecording();

    DeskContext desk_;
};

} // namespace usar::app
