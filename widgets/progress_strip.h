// The strip over the map that says what takes long, how far it is, and takes a Cancel.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include "core/base/clock.h"

namespace usar::widgets {

/// Hidden but while something runs for longer than a moment. GUI thread.
class ProgressStrip : public QFrame {
    Q_OBJECT
public:
    explicit ProgressStrip(QWidget* parent = nullptr);

    /// "Opening run.usarsnap"; how far it is follows, or never.
    void begin(const QString& what);
    /// Of simulated time.
    void setProgress(Seconds done, Seconds whole);
    void end();

signals:
    void cancelRequested();

private:
    QString what_;
    QLabel* text_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QTimer soon_; ///< what is done before it ends needs no strip
};

} // namespace usar::widgets
