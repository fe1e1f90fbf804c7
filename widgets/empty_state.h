// What a view shows while it has nothing to show: what will appear here, and the button that makes it appear.
#pragma once

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace usar::widgets {

/// A title, one sentence, and (with an action) a button. Covers its parent and follows its size; mouse goes through to
/// the parent except on the button.
class EmptyState : public QWidget {
    Q_OBJECT
public:
    explicit EmptyState(QWidget* covered);

    /// What is missing, and how to make it appear; both are the accessible name and description too.
    void setText(const QString& title, const QString& hint);
    /// The button triggers `action` and takes its text; nullptr hides it. The action must outlive this.
    void setAction(QAction* action);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* title_;
    QLabel* hint_;
    QPushButton* button_;
    QMetaObject::Connection clicked_;
};

} // namespace usar::widgets
