// Docks that wait, closed, until they have something to show.
#pragma once

#include <QDockWidget>
#include <QObject>

namespace usar::widgets {

/// At the first start nearly all room is the map's: a dock without content is closed and opens by itself when it gets
/// content for the first time. A dock that was open once, by whatever means, waits no more: from then on only the user
/// opens and closes it. GUI thread; the docks must outlive this object.
class DockOpener : public QObject {
    Q_OBJECT
public:
    explicit DockOpener(const QList<QDockWidget*>& docks, QObject* parent = nullptr);

    /// The object names of those that still wait, for the settings.
    QStringList waiting() const;
    /// Closes those of these that are open now only because a layout was restored. To be called with the names of the
    /// settings; at a first start with those of all.
    void begin(const QStringList& names);
    /// Opens the dock if it waits; it comes to the front of its tabs only if none of them was open.
    void showFirst(QDockWidget* dock);
    /// Calls `arrange`, which may open any dock, and closes again those that still wait, except `shown`.
    template <class Arrange>
    void keepDuring(QDockWidget* shown, Arrange arrange) {
        forgetOpen();
        arranging_ = true;
        arrange();
        close(shown);
        arranging_ = false;
        forgetOpen();
    }

private:
    void close(const QDockWidget* except);
    /// Those that are open wait no more.
    void forgetOpen();

    QList<QDockWidget*> waiting_;
    bool arranging_ = false;
};

} // namespace usar::widgets
