// Strip above the map that names a long operation, shows its progress, and offers Cancel.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include "core/base/clock.h"

namespace usar::widgets {

/// Visible only while an operation takes longer than a moment. GUI thread.
class ProgressStrip : public QFrame {
    Q_OBJECT
public:
    explicit ProgressStrip(QWidget* parent = nullptr);

    /// Starts with a name such as "Opening run.usarsnap"; the progress is unknown until setProgress is called.
    void begin(const QString& what);
    /// Progress in simulated time.
    void setProgress(Seconds done, Seconds whole);
    /// Hides the strip.
    void end();

signals:
    /// The user wants to cancel; the strip stays until end().
    void cancelRequested();

private:
    QString what_;
    QLabel* text_ = new QLabel;
    QProgressBar* bar_ = new QProgressBar;
    QPushButton* cancel_ = new QPushButton(tr("Cancel"));
    QTimer soon_; ///< delays the strip, so that short operations do not show it
};

} // namespace usar::widgets
