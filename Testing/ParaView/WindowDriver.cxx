// SPDX-License-Identifier: BSD-3-Clause
// A plugin of Qt with which a test works a program's window: the program reads a line of JSON from
// its standard input for each thing to do, and answers with a line that begins with "answer ". Qt
// loads it where QT_QPA_GENERIC_PLUGINS names it, so that the program is the one its users have.
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QGenericPlugin>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenu>
#include <QMenuBar>
#include <QPixmap>
#include <QScreen>
#include <QScrollArea>
#include <QSocketNotifier>
#include <QTest>
#include <QTimer>
#include <QWidget>
#include <QWindow>

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace
{
/// Whether a widget is what one word of a path names: "ClassName", "#objectName" or "=text", or
/// several of them in this order.
bool isNamed(const QWidget& widget, const QString& word)
{
  const int equals = word.indexOf('=');
  const QString names = word.left(equals);
  const int sharp = names.indexOf('#');
  const QString type = names.left(sharp);
  return (equals < 0 || widget.property("text").toString().remove('&') == word.mid(equals + 1)) &&
    (sharp < 0 || widget.objectName() == names.mid(sharp + 1)) &&
    (type.isEmpty() || widget.inherits(type.toUtf8().constData()));
}

bool hasPath(const QWidget& widget, const QStringList& words)
{
  if (!isNamed(widget, words.back()))
  {
    return false;
  }
  int left = words.size() - 2;
  for (const QWidget* above = widget.parentWidget(); above && left >= 0;
       above = above->parentWidget())
  {
    left -= isNamed(*above, words[left]) ? 1 : 0;
  }
  return left < 0;
}

/// The first widget on the screen below others of these names, by words with blanks between.
QWidget* find(const QString& path)
{
  const QStringList words = path.split(' ');
  for (QWidget* widget : QApplication::allWidgets())
  {
    if (widget->isVisible() && hasPath(*widget, words))
    {
      return widget;
    }
  }
  return nullptr;
}

/// What gets the mouse's events at a place of the screen.
QWindow* windowAt(const QPoint& place)
{
  QWindow* window = QGuiApplication::topLevelAt(place);
  for (QWindow* inner = window; inner;)
  {
    window = inner;
    inner = nullptr;
    for (QObject* child : window->children())
    {
      auto* below = qobject_cast<QWindow*>(child);
      if (below && below->isVisible() &&
        QRect(below->mapToGlobal(QPoint(0, 0)), below->size()).contains(place))
      {
        inner = below;
      }
    }
  }
  return window;
}

QString moveTo(const QPoint& place)
{
  QWindow* window = windowAt(place);
  if (!window)
  {
    return "nothing is there";
  }
  QCursor::setPos(place);
  QTest::mouseMove(window, window->mapFromGlobal(place));
  return {};
}

QString clickAt(const QPoint& place, bool twice)
{
  QString wrong = moveTo(place);
  if (wrong.isEmpty())
  {
    QWindow* window = windowAt(place);
    const QPoint there = window->mapFromGlobal(place);
    if (!QGuiApplication::focusWindow()) // as a window manager does, and here may be none
    {
      window->requestActivate();
      // Clicks arrive without the focus as well.
      static_cast<void>(QTest::qWaitFor([] { return QGuiApplication::focusWindow() != nullptr; }));
    }
    if (twice)
    {
      QTest::mouseDClick(window, Qt::LeftButton, {}, there);
    }
    else
    {
      QTest::mouseClick(window, Qt::LeftButton, {}, there);
    }
  }
  return wrong;
}

/// Where the text of a row begins at the latest, behind icons: some views take no click beyond its
/// end.
constexpr int textStart = 60;

/// The row of a view with this text, wherever in its tree; invalid where there is none.
QModelIndex findRow(const QAbstractItemView& view, const QString& text)
{
  const QAbstractItemModel* model = view.model();
  for (int column = 0; column < model->columnCount(); ++column)
  {
    const QModelIndexList rows = model->match(model->index(0, column, view.rootIndex()),
      Qt::DisplayRole, text, 1, Qt::MatchExactly | Qt::MatchRecursive | Qt::MatchWrap);
    if (!rows.isEmpty())
    {
      return rows.front();
    }
  }
  return {};
}

/// Where in a widget, scrolled into sight: its middle, or at the fractions "x" and "y" of its size,
/// or in the row whose text is "row".
QPoint placeIn(QWidget& widget, const QJsonObject& wish)
{
  for (QWidget* above = widget.parentWidget(); above; above = above->parentWidget())
  {
    if (auto* area = qobject_cast<QScrollArea*>(above))
    {
      area->ensureWidgetVisible(&widget);
    }
  }
  auto* view = qobject_cast<QAbstractItemView*>(&widget);
  if (view && wish.contains("row"))
  {
    const QModelIndex row = findRow(*view, wish["row"].toString());
    view->scrollTo(row);
    const QRect box = view->visualRect(row);
    const int onText = std::min(box.width() / 2, textStart);
    return view->viewport()->mapToGlobal(QPoint(box.left() + onText, box.center().y()));
  }
  return widget.mapToGlobal(QPoint(
    int(wish["x"].toDouble(0.5) * widget.width()), int(wish["y"].toDouble(0.5) * widget.height())));
}

/// \param text of an entry; "first: TEXT" where it must be the first of the menu
template <typename Menu>
QString clickAction(Menu* menu, QString text)
{
  const bool first = text.startsWith("first: ");
  text.remove("first: ");
  for (QAction* action : menu->actions())
  {
    if (action->isVisible() && action->text().remove('&') == text)
    {
      return clickAt(menu->mapToGlobal(menu->actionGeometry(action).center()), false);
    }
    if (first && action->isVisible())
    {
      return "the first entry of the menu is " + action->text();
    }
  }
  return "no such entry in the menu: " + text;
}

/// Opens menu after menu as a hand does, and takes the last entry.
QString takeFromMenu(QMenuBar* bar, const QJsonArray& texts)
{
  QString wrong = clickAction(bar, texts[0].toString());
  for (int k = 1; k < texts.size() && wrong.isEmpty(); ++k)
  {
    QMenu* menu = nullptr;
    for (int tries = 0; tries < 100 && !menu; ++tries)
    {
      QTest::qWait(20);
      for (QWidget* widget : QApplication::topLevelWidgets())
      {
        auto* open = qobject_cast<QMenu*>(widget);
        const bool isNext =
          open && open->isVisible() && open->title().remove('&') == texts[k - 1].toString();
        menu = isNext ? open : menu;
      }
    }
    wrong = menu ? clickAction(menu, texts[k].toString()) : QString("the menu does not open");
  }
  return wrong;
}

QString press(const QString& keys)
{
  QWindow* window = QGuiApplication::focusWindow();
  if (!window)
  {
    return "no window has the keyboard";
  }
  const QKeySequence sequence(keys);
  for (int k = 0; k < sequence.count(); ++k)
  {
    const int code = sequence[static_cast<unsigned>(k)];
    const int modifiers = code & int(Qt::KeyboardModifierMask);
    QTest::keyClick(window, Qt::Key(code & ~modifiers), Qt::KeyboardModifiers(modifiers));
  }
  return {};
}

QString type(const QString& text)
{
  QWindow* window = QGuiApplication::focusWindow();
  if (!window)
  {
    return "no window has the keyboard";
  }
  for (const QChar character : text)
  {
    QTest::keyClick(window, character.toLatin1());
  }
  return {};
}

QString done(const QJsonObject& wish)
{
  const QString what = wish["do"].toString();
  if (what == "press")
  {
    return press(wish["keys"].toString());
  }
  if (what == "type")
  {
    return type(wish["text"].toString());
  }
  if (what == "picture")
  {
    const QPixmap shot = QGuiApplication::primaryScreen()->grabWindow(0);
    return shot.save(wish["file"].toString()) ? QString() : QString("the picture is not saved");
  }
  QWidget* widget = find(wish["widget"].toString());
  if (!widget)
  {
    return "no such widget on the screen";
  }
  if (what == "menu")
  {
    return takeFromMenu(qobject_cast<QMenuBar*>(widget), wish["entries"].toArray());
  }
  if (what == "move")
  {
    return moveTo(placeIn(*widget, wish));
  }
  if (what == "click" || what == "double")
  {
    return clickAt(placeIn(*widget, wish), what == "double");
  }
  if (what == "size")
  {
    widget->setGeometry(
      0, 0, wish["width"].toInt(widget->width()), wish["height"].toInt(widget->height()));
    widget->activateWindow();
    return {};
  }
  return what == "look" ? QString() : QString("no such thing to do");
}

/// Clicks that opened a dialog, and have not come back.
int opened = 0;

void answer(const QString& wrong, const QJsonValue& value)
{
  const QJsonObject said{ { "wrong", wrong }, { "value", value }, { "opened", opened } };
  std::printf("answer %s\n", QJsonDocument(said).toJson(QJsonDocument::Compact).constData());
  std::fflush(stdout);
}

void obey(const QByteArray& line)
{
  const QJsonObject wish = QJsonDocument::fromJson(line).object();
  if (wish["opens"].toBool())
  {
    // What opens a dialog comes back when that is closed, and the answer must not wait for it.
    ++opened;
    QTimer::singleShot(0, qApp, [wish] {
      const QString wrong = done(wish);
      --opened;
      if (!wrong.isEmpty())
      {
        std::fprintf(stderr, "%s\n", wrong.toUtf8().constData());
      }
    });
    answer({}, {});
    return;
  }
  const QString wrong = done(wish);
  QJsonValue value;
  if (wrong.isEmpty() && wish.contains("property"))
  {
    const QByteArray name = wish["property"].toString().toUtf8();
    value = QJsonValue::fromVariant(find(wish["widget"].toString())->property(name.constData()));
  }
  answer(wrong, value);
}

class Listener : public QObject
{
public:
  Listener()
    : Notifier(STDIN_FILENO, QSocketNotifier::Read)
  {
    connect(&this->Notifier, &QSocketNotifier::activated, this, [this] { this->listen(); });
  }

private:
  void listen()
  {
    char bytes[4096];
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0)
    {
      this->Notifier.setEnabled(false);
      return;
    }
    this->Heard.append(bytes, static_cast<int>(count));
    for (int end = this->Heard.indexOf('\n'); end >= 0; end = this->Heard.indexOf('\n'))
    {
      const QByteArray line = this->Heard.left(end);
      this->Heard.remove(0, end + 1);
      obey(line);
    }
  }

  QSocketNotifier Notifier;
  QByteArray Heard;
};
}

class WindowDriver : public QGenericPlugin
{
  Q_OBJECT
  Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "WindowDriver.json")

public:
  QObject* create(const QString&, const QString&) override { return new Listener; }
};

#include "WindowDriver.moc"
