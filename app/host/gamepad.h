// The gamepad that is plugged in, if any: its sticks as one stick, and its buttons.
#pragma once

#include <memory>

#include <QObject>
#include <QString>

#include "core/base/stick.h"

namespace usar::app {

/// By SDL's mappings, so that buttons and sticks are where they are on every pad. The left stick drives and turns, the
/// right one goes sideways, up and down; both have a dead zone. Read in a thread of its own; signals come in the thread
/// that this lives in, the GUI's. Several pads: the first that was plugged in counts. Without SDL 2 in the build there
/// is never one.
class Gamepad : public QObject {
    Q_OBJECT
public:
    explicit Gamepad(QObject* parent = nullptr);
    ~Gamepad() override;

    static bool supported();
    /// Begins to look for pads; again: nothing.
    void start();
    /// Of the one that counts; empty: none.
    const QString& name() const { return name_; }

signals:
    /// It looks for pads now.
    void started();
    void plugged(const QString& name);
    void unplugged(const QString& name);
    void moved(const usar::Stick& stick);
    void stopPressed(); ///< the button on the right (B, circle)
    void takePressed(); ///< Start

private:
    class Reader;
    std::unique_ptr<Reader> reader_;
    QString name_;
};

} // namespace usar::app
