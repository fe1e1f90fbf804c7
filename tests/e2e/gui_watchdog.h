// Measures how long the GUI thread is blocked by a single event.
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QString>

/// An application that times the delivery of every event, nested ones as part of the outer. Event loops that run inside
/// an event (a dialog) are not a block and are not counted, and neither is the time in which other programs had the
/// processor; where the disk had to be waited for, only what was computed counts. What is longer than half of what is
/// allowed is taken in terms of an undisturbed machine. That cannot tell all that other programs slow down, so tests
/// that run beside others find real blocks only (a wait for a server, a file or a thread), and those that run alone ask
/// for the limit that a person would notice. GUI thread.
class GuiWatchdog : public QApplication {
public:
    GuiWatchdog(int& argc, char** argv);

    bool notify(QObject* receiver, QEvent* event) override;

    static GuiWatchdog& instance() { return *static_cast<GuiWatchdog*>(qApp); }

    /// "131 ms in QWidget map, event 12" where an event took longer than it may since the last reset.
    QByteArray complaint() const;
    void reset();
    /// `reset`, and from now on allows only what a person does not notice: 100 ms. For tests that run alone.
    void resetStrictly();

private:
    struct Moment {
        double waited_ms = 0.0; ///< ready to run, but without a processor
        double computed_ms = 0.0;
        long waits_for_disk = 0;
    };

    static Moment now();
    static double blocked_ms(double elapsed_ms, const Moment& before);
    /// How many times longer the same painting takes now than undisturbed; at least 1.
    double slowness();

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    static constexpr qint64 strict_ms = 500; // everything is several times slower there
#else
    static constexpr qint64 strict_ms = 100;
#endif

    qint64 allowed_ms_ = 3 * strict_ms;
    double undisturbed_ms_;
    qint64 longest_ms_ = 0;
    QString where_;
    int depth_ = 0;
};
