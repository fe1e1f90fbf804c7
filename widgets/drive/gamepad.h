// The gamepad that is plugged in, if any: its two sticks as one Stick, and two of its buttons.
#pragma once

#include <memory>

#include <QObject>
#include <QString>

#include "core/base/stick.h"

namespace usar::widgets {

/// Uses SDL's mappings, so that sticks and buttons have the same places on every pad. The left stick drives and turns,
/// the right one moves sideways, up and down; both have a dead zone. The pad is read in a thread of its own; signals
/// are emitted in the GUI thread, to which this object belongs. If several pads are plugged in, the first one found is
/// used until it is unplugged. Without SDL 2 in the build there is never a gamepad.
class Gamepad : public QObject {
    Q_OBJECT
public:
    explicit Gamepad(QObject* parent = nullptr);
    /// Waits for the reading thread to end.
    ~Gamepad() override;

    /// False if the program was built without SDL 2.
    static bool supported();
    /// Starts looking for pads; further calls have no effect.
    void start();
    /// Name of the pad in use; empty: none.
    const QString& name() const { return name_; }

signals:
    /// The search for pads has begun; not emitted if SDL cannot be initialized.
    void started();
    void plugged(const QString& name);
    void unplugged(const QString& name);
    /// The sticks have a new position, with the dead zone applied.
    void moved(const usar::Stick& stick);
    void stopPressed(); ///< the button on the right (B, circle)
    void takePressed(); ///< the Start button

private:
    class Reader;
    std::unique_ptr<Reader> reader_; ///< null until `start`
    QString name_;
};

} // namespace usar::widgets
