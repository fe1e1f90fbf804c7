// Home and End for the widget that has the focus and means something by them, though the window has a command there.
#pragma once

#include <QObject>

namespace usar::widgets {

/// Sliders, lists and choices go to their ends by these keys, as everywhere; elsewhere the key is the window's. Watches
/// the application as long as it lives. GUI thread.
class OwnKeys : public QObject {
public:
    explicit OwnKeys(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace usar::widgets
