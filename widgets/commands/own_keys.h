// Gives Home and End to the focused widget if it uses them, although the window has a command on these keys.
#pragma once

#include <QObject>

namespace usar::widgets {

/// Sliders, lists and combo boxes go to their ends with these keys; in other widgets the key triggers the window's
/// command. Event filter on the application for as long as this object exists. GUI thread.
class OwnKeys : public QObject {
public:
    explicit OwnKeys(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace usar::widgets
