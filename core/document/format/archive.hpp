#pragma once

// ReadArchive and WriteArchive: the two directions of the file format. One function describe(archive, value)
// for each struct names its members, their limits and checks, in the order in which they are written; both
// archives go through it.

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/text/enum_words.hpp"
#include "core/base/vector.hpp"
#include "core/document/format/document_text.hpp"
#include "core/document/format/json_cursor.hpp"
#include "core/document/format/kept_members.hpp"
#include "core/document/history/shared.hpp"

namespace hariko::detail {

/// Value that an archive describes; constant where it is written.
template <class Archive, class T>
using Described = std::conditional_t<Archive::reads, T, const T>;

/// Largest id in files.
inline constexpr std::uint32_t max_id = no_index - 1;

// Rules for values, checked when they are read. They follow a member's value; those that a list does not take
// itself are rules for its entries, those of a struct go to its description.

/// Limits of a whole number or an id.
struct Whole {
  std::uint32_t low = 0, high = max_id;
};
/// Limits of a number, and the message for others.
struct Range {
  double low, high;
  std::string_view text;
};
/// Limits of the number of entries.
struct Count {
  std::size_t low = 0, high = std::size_t(-1);
};
/// Number of entries that are read at most; the others are passed over.
struct First {
  std::size_t count;
};
/// Each entry is above the one before.
struct Ascending {
  std::string_view text = "entries must be in ascending order, each once";
};

inline constexpr double above_zero = std::numeric_limits<double>::denorm_min();
inline constexpr double largest_number = std::numeric_limits<double>::max();
inline constexpr Range positive{above_zero, largest_number, "a positive number was expected"};

// Values.
void read_value(JsonReader& reader, const JsonCursor& at, bool& value);
void read_value(JsonReader& reader, const JsonCursor& at, double& value);
void read_value(JsonReader& reader, const JsonCursor& at, double& value, const Range& range);
void read_value(JsonReader& reader, const JsonCursor& at, double& value, const Range& a, const Range& b);
void read_value(JsonReader& reader, const JsonCursor& at, std::uint32_t& value, const Whole& limits = {});
void read_value(JsonReader& reader, const JsonCursor& at, int& value, const Whole& limits);
void read_value(JsonReader& reader, const JsonCursor& at, std::string& value);
void read_value(JsonReader& reader, const JsonCursor& at, Vector3& value);
inline void write_value(DocumentText& text, bool value) {
  text.boolean(value);
}
inline void write_value(DocumentText& text, double value) {
  text.number(value);
}
inline void write_value(DocumentText& text, std::uint32_t value) {
  text.number(value);
}
inline void write_value(DocumentText& text, int value) {
  text.number(static_cast<std::uint32_t>(value));
}
inline void write_value(DocumentText& text, const std::string& value) {
  text.string(value);
}
inline void write_value(DocumentText& text, const Vector3& value) {
  text.vector(value);
}

/// Reads one struct by its description.
class ReadArchive {
 public:
  static constexpr bool reads = true;
  ReadArchive(JsonReader& reader, const JsonCursor& at)
      : reader_(reader), at_(at), failed_before_(reader.failed()) {}

  // Every description begins with the layout: an object with a line for each member, an object on one line,
  // or a row of values in brackets.
  void lines() { reader_.is_object(at_); }
  void line() { reader_.is_object(at_); }
  void row(std::size_t size) {
    refuses_ = false;
    reader_.array_size(at_, size, size);
  }
  /// Ends the description; unknown members are an error unless they are kept or ignored.
  void close();

  /// Member that every file has.
  template <class T, class... Rules>
  void required(std::string_view name, T& value, const Rules&... rules) {
    if (const JsonMember* member = take(name, true))
      read_value(reader_, JsonCursor(at_, *member), value, rules...);
  }
  /// Member that is always written, an optional value where there is one; without it a value stays as it is.
  template <class T, class... Rules>
  void member(std::string_view name, T& value, const Rules&... rules) {
    if (const JsonMember* member = take(name, false))
      read_value(reader_, JsonCursor(at_, *member), value, rules...);
  }
  /// Member that is written where it differs from the usual value, which it has in files without it.
  template <class T, class... Rules>
  void changed(std::string_view name, T& value, const std::type_identity_t<T>& usual, const Rules&... rules) {
    value = usual;
    member(name, value, rules...);
  }
  /// List with a line for each entry, written unless it is empty.
  template <class T, class... Rules>
  void list(std::string_view name, T& values, const Rules&... rules) {
    member(name, values, rules...);
  }
  /// The same, always written, in every file.
  template <class T, class... Rules>
  void required_list(std::string_view name, T& values, const Rules&... rules) {
    required(name, values, rules...);
  }
  /// List of keys with values, ascending by the keys; body(row, key, value) describes an entry.
  template <class Key, class Value, class Body>
  void rows(std::string_view name, FlatMap<Key, Value>& map, Body&& body) {
    with(name, [&](const JsonCursor& list) {
      std::optional<Key> last;
      reader_.for_each(list, [&](const JsonCursor& at) {
        Key key;
        Value value{};
        ReadArchive row(reader_, at);
        body(row, key, value);
        row.close();
        if (last && !(*last < key)) reader_.fail(at, std::string(Ascending{}.text));
        if (reader_.failed()) return;
        last = key;
        map.set(key, std::move(value));
      });
    });
  }
  /// Row of values with one rule, in every file.
  template <class Rule, class... Values>
  void required_row(std::string_view name, const Rule& rule, Values&... values) {
    const JsonMember* member = take(name, true);
    if (!member) return;
    const JsonCursor list(at_, *member);
    ReadArchive row(reader_, list);
    row.row(sizeof...(values));
    (row.entry(values, rule), ...);
  }
  /// Next value of a row.
  template <class T, class... Rules>
  void entry(T& value, const Rules&... rules) {
    const std::size_t i = next_++;
    if (!reader_.failed()) read_value(reader_, JsonCursor(at_, i), value, rules...);
  }
  /// Member that nothing is read from.
  void constant(std::string_view name, std::string_view) { take(name, false); }
  void constant(std::string_view name, std::uint32_t) { take(name, false); }
  /// Members that mean nothing here, and yet are no unknown ones.
  void known(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) take(name, false);
  }
  /// Describes a shared value, whose members are those of the struct that holds it.
  template <class T, class Body>
  void shared(Shared<T>& value, Body&& body) {
    T own = *value;
    body(own);
    value = std::move(own);
  }
  /// Unknown members, which are kept.
  template <class Kept>
  void kept(Kept& kept) {
    refuses_ = false;
    kept = unknown();
  }
  /// Lets unknown members be.
  void others_ignored() { refuses_ = false; }

  /// Value of a member that is missing.
  template <class T>
  void assume(T& value, const std::type_identity_t<T>& what) {
    value = what;
  }
  /// Whether the file has an older version.
  bool before(int version) const { return reader_.version() < version; }
  /// Checks by a function that returns Result<Done>.
  template <class Check>
  void check(Check&& check) {
    if (reader_.failed()) return;
    if (const auto checked = check(); !checked) reader_.fail(at_, checked.error());
  }
  /// Reports E_SCHEMA where a condition does not hold.
  template <class Holds>
  void require(Holds&& holds, std::string_view text) {
    if (!reader_.failed() && !holds()) reader_.fail(at_, std::string(text));
  }

  // Access for what is read in another way than it is written.
  JsonReader& reader() { return reader_; }
  const JsonCursor& at() const { return at_; }
  bool has(std::string_view name) const { return reader_.find(at_, name) != nullptr; }
  /// Calls body(const JsonCursor&) for the member, if there is one.
  template <class Body>
  void with(std::string_view name, Body&& body) {
    if (const JsonMember* member = take(name, false)) body(JsonCursor(at_, *member));
  }
  /// The same for a member of every file.
  template <class Body>
  void with_required(std::string_view name, Body&& body) {
    if (const JsonMember* member = take(name, true)) body(JsonCursor(at_, *member));
  }

 private:
  /// Marks a member as known; nullptr where there is none, or after an error.
  const JsonMember* take(std::string_view name, bool required);
  KeptMembers unknown() const;

  JsonReader& reader_;
  const JsonCursor& at_;
  std::vector<const JsonMember*> taken_;
  std::size_t next_ = 0;
  bool failed_before_, refuses_ = true;
};

/// Writes one struct by its description; the functions are those of ReadArchive.
class WriteArchive {
 public:
  static constexpr bool reads = false;
  explicit WriteArchive(DocumentText& text) : text_(text) {}

  void lines() {
    layout_ = Layout::lines;
    text_.open('{');
  }
  void line() {
    layout_ = Layout::line;
    text_.raw("{");
  }
  void row(std::size_t) {
    layout_ = Layout::row;
    text_.raw("[");
  }
  void close();

  template <class T, class... Rules>
  void required(std::string_view name, const T& value, const Rules&...) {
    key(name);
    write_value(text_, value);
  }
  template <class T, class... Rules>
  void member(std::string_view name, const T& value, const Rules&...) {
    required(name, value);
  }
  template <class T, class... Rules>
  void member(std::string_view name, const std::optional<T>& value, const Rules&...) {
    if (value) required(name, *value);
  }
  template <class T, class... Rules>
  void changed(std::string_view name, const T& value, const std::type_identity_t<T>& usual, const Rules&...) {
    if (!(value == usual)) required(name, value);
  }
  template <class T, class... Rules>
  void list(std::string_view name, const T& values, const Rules&...) {
    if (!values.empty()) required_list(name, values);
  }
  template <class T, class... Rules>
  void required_list(std::string_view name, const T& values, const Rules&...) {
    lines_of(name, values, [&](const auto& value) { write_value(text_, value); });
  }
  template <class Key, class Value, class Body>
  void rows(std::string_view name, const FlatMap<Key, Value>& map, Body&& body) {
    if (map.empty()) return;
    lines_of(name, map, [&](const auto& entry) {
      WriteArchive row(text_);
      body(row, entry.first, entry.second);
      row.close();
    });
  }
  /// Rows with a number; body(row, i) writes the entries of one.
  template <class Body>
  void numbered_rows(std::string_view name, std::size_t count, Body&& body) {
    key(name);
    text_.open('[');
    for (std::size_t i = 0; i < count; ++i) {
      text_.next();
      WriteArchive row(text_);
      row.row(0);
      body(row, static_cast<Index>(i));
      row.close();
    }
    text_.close(']');
  }
  template <class Rule, class... Values>
  void required_row(std::string_view name, const Rule&, const Values&... values) {
    key(name);
    WriteArchive row(text_);
    row.row(sizeof...(values));
    (row.entry(values), ...);
    row.close();
  }
  template <class T, class... Rules>
  void entry(const T& value, const Rules&...) {
    next();
    write_value(text_, value);
  }
  void constant(std::string_view name, std::string_view word) {
    key(name);
    text_.string(word);
  }
  void constant(std::string_view name, std::uint32_t number) { required(name, number); }
  void known(std::initializer_list<std::string_view>) {}
  template <class T, class Body>
  void shared(const Shared<T>& value, Body&& body) {
    body(*value);
  }
  void kept(const KeptMembers& kept) { text_.kept(kept); }
  void kept(const Shared<KeptMembers>& kept) { text_.kept(*kept); }
  void others_ignored() {}

  template <class T>
  void assume(const T&, const std::type_identity_t<T>&) {}
  bool before(int) const { return false; }
  template <class Check>
  void check(Check&&) {}
  template <class Holds>
  void require(Holds&&, std::string_view) {}

 private:
  enum class Layout : std::uint8_t { lines, line, row };
  void key(std::string_view name);
  void next();
  template <class Values, class Write>
  void lines_of(std::string_view name, const Values& values, Write&& write) {
    key(name);
    text_.open('[');
    for (const auto& value : values) {
      text_.next();
      write(value);
    }
    text_.close(']');
  }

  DocumentText& text_;
  Layout layout_ = Layout::lines;
  bool first_ = true;
};

template <class T, class... Rules>
void read_described(JsonReader& reader, const JsonCursor& at, T& value, const Rules&... rules) {
  ReadArchive archive(reader, at);
  describe(archive, value, rules...);
  archive.close();
}
template <class T>
void write_described(DocumentText& text, const T& value) {
  WriteArchive archive(text);
  describe(archive, value);
  archive.close();
}

/// Enumerations, ids, and structs with a description; rules of a struct go to its description.
template <class T, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, T& value, const Rules&... rules) {
  if constexpr (std::is_enum_v<T>)
    value = static_cast<T>(reader.choice(at, enum_words<T>));
  else if constexpr (requires { value.value = std::uint32_t{}; })
    read_value(reader, at, value.value, rules...);
  else
    read_described(reader, at, value, rules...);
}
template <class T>
void write_value(DocumentText& text, const T& value) {
  if constexpr (std::is_enum_v<T>)
    text.string(enum_word(value));
  else if constexpr (requires { value.value == std::uint32_t{}; })
    text.number(value.value);
  else
    write_described(text, value);
}

template <class T, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, std::optional<T>& value, const Rules&... rules) {
  read_value(reader, at, value.emplace(), rules...);
}

template <class T, std::size_t N, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, std::array<T, N>& values, const Rules&... rules) {
  if (reader.array_size(at, N, N) != N) return;
  for (std::size_t i = 0; i < N && !reader.failed(); ++i)
    read_value(reader, JsonCursor(at, i), values[i], rules...);
}
template <class T, std::size_t N>
void write_value(DocumentText& text, const std::array<T, N>& values) {
  text.row(N, [&](std::size_t i) { write_value(text, values[i]); });
}

/// An entry is read before it goes into its list, so that its rules can look at those before it.
template <class T, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, std::vector<T>& values, const Rules&... rules) {
  reader.for_each(at, [&](const JsonCursor& entry) {
    T value{};
    read_value(reader, entry, value, rules...);
    values.push_back(std::move(value));
  });
}
template <class T, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, std::vector<T>& values, const Count& count,
                const Rules&... rules) {
  reader.array_size(at, count.low, count.high);
  read_value(reader, at, values, rules...);
}
template <class T, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, std::vector<T>& values, const First& first,
                const Rules&... rules) {
  reader.for_each(at, [&](const JsonCursor& entry) {
    if (values.size() < first.count) read_value(reader, entry, values.emplace_back(), rules...);
  });
}
template <class T, class... Rules>
void read_value(JsonReader& reader, const JsonCursor& at, std::vector<T>& values, const Ascending& ascending,
                const Rules&... rules) {
  reader.for_each(at, [&](const JsonCursor& entry) {
    T value{};
    read_value(reader, entry, value, rules...);
    if (!values.empty() && !(values.back() < value)) reader.fail(entry, std::string(ascending.text));
    values.push_back(std::move(value));
  });
}
template <class T>
void write_value(DocumentText& text, const std::vector<T>& values) {
  text.row(values.size(), [&](std::size_t i) { write_value(text, values[i]); });
}

/// Edge by its vertices; `order` is the message where the larger id comes first.
template <class Archive>
void describe(Archive& archive, Described<Archive, EdgeId>& edge, std::string_view order = {}) {
  archive.row(2);
  archive.entry(edge.low);
  archive.entry(edge.high);
  archive.require([&] { return edge.low < edge.high; }, order);
}

}  // namespace hariko::detail
