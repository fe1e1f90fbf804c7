// What a screen reader finds in a program's windows: each widget's role, name, state and place.
#pragma once

#include <functional>
#include <optional>

#include <QDBusConnection>
#include <QRect>
#include <QString>

namespace usar::hands {

/// A widget as the program describes it on the accessibility bus (AT-SPI 2).
struct Seen {
    QString service; ///< address of the program on the bus
    QString path;    ///< address of the widget in the program
    QString role;    ///< "push button", "label", "check box", "table cell"
    QString name;
    QString description;
    QRect at;           ///< on the screen; empty if the widget is nowhere
    quint64 states = 0; ///< bits of AT-SPI's StateType

    bool showing() const { return states >> 25 & 1 && !at.isEmpty(); }
    bool enabled() const { return states >> 8 & 1; }
    /// True for a window that has the keyboard.
    bool active() const { return states >> 1 & 1; }
    bool checked() const { return states >> 4 & 1; }
    bool focused() const { return states >> 12 & 1; }
    bool selected() const { return states >> 23 & 1; }
};

/// Reads all programs on one desktop. Each call asks anew, which takes a tenth of a second for a large window.
class ScreenReader {
public:
    ScreenReader(const QDBusConnection& bus, const QSize& screen_px);

    using Wanted = std::function<bool(const Seen&)>;
    /// The first widget on the screen that is wanted, top down; waits until there is one. nullopt after `within_ms`.
    std::optional<Seen> find(const Wanted& wanted, int within_ms = 15000) const;
    /// The same, by role and a name that contains these words, ignoring case and mnemonics.
    std::optional<Seen> find(const QString& role, const QString& name, int within_ms = 15000) const;
    /// All widgets on the screen that are wanted, now.
    std::vector<Seen> all(const Wanted& wanted) const;
    /// Text of a field; what a spin box shows, too.
    QString textOf(const Seen& field) const;

private:
    /// Visits what is on the screen of all that is in `parent`, until `visit` returns true.
    bool walk(const Seen& parent, const Wanted& visit) const;

    QDBusConnection bus_;
    QRect screen_px_; ///< Qt puts docks that are behind a tab outside of it.
};

} // namespace usar::hands
