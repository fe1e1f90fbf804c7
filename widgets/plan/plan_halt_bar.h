// Bar that says that a plan is halted, where and why, with buttons to continue.
#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QToolButton>

namespace usar::widgets {

/// Hidden while there is nothing to say. The buttons belong to commands. GUI thread.
class PlanHaltBar : public QFrame {
    Q_OBJECT
public:
    explicit PlanHaltBar(QWidget* parent = nullptr);

    /// Makes a button for each action; the actions must outlive the bar.
    void setActions(const QList<QAction*>& actions);
    /// Shows a sentence; empty hides the bar.
    void setText(const QString& text);
    QString text() const { return text_->text(); }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void showIcon();

    QBoxLayout* column_;
    QLabel* icon_;
    QLabel* text_;
    QBoxLayout* buttons_;
};

} // namespace usar::widgets
