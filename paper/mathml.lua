-- Formulas for the weaver: Pandoc's MathML, mended where browsers draw it otherwise than it is meant.
-- MathML Core, which they implement, has no mathvariant but on <mi>, no columnalign and no bare
-- numbers as sizes; it takes a minus for a sum's wherever it is not told; and brackets that may
-- stretch are set as wide as the widest of their forms. dofile() gives one function: the TeX of a
-- formula and "InlineMath" or "DisplayMath" to HTML, or nil for a formula that Pandoc cannot read.

-- The versions of Pandoc write the same formula in different ways; what is mended is the way of 2.17,
-- and first all others are brought to it.

local signs = { ["+"] = true, ["−"] = true, ["±"] = true, ["∓"] = true }

--- Bars that all open, as later versions have them, open and close by turns; a single one stays.
local function pair_bars(html)
  local opening, closing = '<mo stretchy="false" form="prefix">|', '<mo stretchy="false" form="postfix">|'
  local count = select(2, html:gsub(opening, ""))
  if count % 2 == 1 or html:find(closing, 1, true) then return html end
  local bars = 0
  return (html:gsub(opening, function()
    bars = bars + 1
    return bars % 2 == 0 and closing or nil
  end))
end

--- Later versions write signs and names of functions as <mi>, these with an invisible operator
--- behind, upright letters each by itself, and sizes in per cent.
local function in_one_way(html)
  local count
  html = html:gsub("<mi>([^<]*)</mi>", function(text) return signs[text] and "<mo>" .. text .. "</mo>" end)
    :gsub("&#8289;", "\u{2061}")
    :gsub("<mrow><mi[^>]*>(%a%a+)</mi><mo>\u{2061}</mo></mrow>", "<mo>%1</mo>")
    :gsub("<mi[^>]*>(%a%a+)</mi><mo>\u{2061}</mo>", "<mo>%1</mo>")
    :gsub('minsize="(%d+)%%" maxsize="%d+%%" stretchy="true"', function(percent)
      return string.format('minsize="%g" maxsize="%g" stretchy="false"', percent / 100, percent / 100)
    end)
  repeat
    html, count = html:gsub('(<mi mathvariant="normal">%a+)</mi><mi mathvariant="normal">(%a)', "%1%2")
  until count == 0
  return pair_bars(html)
end

local stretching = '()<mo stretchy="true" form="(%l+)">()'

--- Whether something between brackets is taller than a line; in a line of text a root is not.
local function is_tall(html, kind)
  for _, mark in ipairs({ "<mfrac", "<munder", "<mtable", "∑", "∫", kind == "DisplayMath" and "<msqrt" or "<mtable" }) do
    if html:find(mark, 1, true) then return true end
  end
  return false
end

--- Pairs the stretching brackets; those round something flat stretch no more.
local function settle_brackets(html, kind)
  local opened, flat = {}, {}
  for from, form, to in html:gmatch(stretching) do
    if form == "prefix" then
      table.insert(opened, { from = from, to = to })
    elseif #opened > 0 then
      local left = table.remove(opened)
      local settled = not is_tall(html:sub(left.to, from), kind)
      flat[left.from], flat[from] = settled, settled
    end
  end
  return (html:gsub(stretching, function(from, form)
    return string.format('<mo stretchy="%s" form="%s">', not flat[from], form)
  end))
end

--- Letters that are upright together are one word.
local function join_words(html)
  return (html:gsub('<mstyle mathvariant="normal">(.-)</mstyle>', function(inside)
    return inside:gsub("</mi><mi>", ""):gsub("^<mi>([^<]*)</mi>$", '<mi mathvariant="normal">%1</mi>')
  end))
end

--- A function's name keeps a thin distance, but none from a bracket that follows it.
local function space_names(html)
  return (html:gsub("<mo>(%a%a+)</mo>()", function(name, behind)
    local bracket = html:find("^<mrow><mo", behind) or html:find('^<mo stretchy="%l+" form="prefix">', behind)
    return string.format('<mo lspace="0.167em" rspace="%s">%s</mo>', bracket and "0" or "0.167em", name)
  end))
end

--- \big brackets are a larger type, the bigger ones stretch. A power on one belongs to all that is
--- in the brackets; alone in the base, the bracket would keep its size.
local function size_brackets(html)
  return (html:gsub('minsize="1.2" maxsize="1.2" stretchy="false"', 'mathsize="1.2em" stretchy="false"')
    :gsub('minsize="([%d.]+)" maxsize="[%d.]+" stretchy="false"',
          'minsize="%1em" maxsize="%1em" stretchy="true"')
    :gsub('(<mo minsize="[^>]*prefix">.-)<msup>(<mo minsize="[^>]*postfix">[^<]*</mo>)',
      function(inside, bracket)
        local balanced = select(2, inside:gsub("<%a", "")) == select(2, inside:gsub("</", ""))
        return balanced and "<msup><mrow>" .. inside .. bracket .. "</mrow>" or nil
      end))
end

--- A minus or plus with no term before it is a sign.
local function mark_signs(html)
  for _, sign in ipairs({ "−", "+", "±", "∓" }) do
    local marked = '<mo form="prefix">' .. sign .. "</mo>"
    local plain = "<mo>" .. sign:gsub("%p", "%%%0") .. "</mo>"
    html = html:gsub("(<mo([^>]*)>[^<]*</mo>)" .. plain, function(before, attributes)
        return not attributes:find("postfix") and before .. marked or nil
      end)
      :gsub("(<mspace[^>]*></mspace>)" .. plain, "%1" .. marked)
  end
  return html
end

local function written(tex, kind)
  tex = tex:gsub("\\Bigl%f[%A]", "\\Big") -- which alone of its kind Pandoc does not know
  local html = pandoc.write(pandoc.Pandoc({ pandoc.Plain({ pandoc.Math(kind, tex) }) }), "html5",
                            { html_math_method = "mathml", wrap_text = "none" })
  if not html:match("^<math") then return nil end
  html = mark_signs(size_brackets(space_names(join_words(in_one_way(html)))))
    :gsub("<mo>%*</mo>", "<mo>∗</mo>") -- the other one is raised already
    :gsub("<mo>(ℓ)</mo>", "<mi>%1</mi>"):gsub("<mo>(𝜚)</mo>", "<mi>%1</mi>") -- letters, no operators
    :gsub('<mo accent="true">\u{302}', '<mo accent="true" stretchy="false">ˆ') -- no width of its own,
    :gsub('<mo accent="true">\u{303}', '<mo accent="true" stretchy="false">˜') -- and so beside the letter
    :gsub('<mtable>(<mtr><mtd columnalign="right")', '<mtable class="aligned" displaystyle="true">%1')
  html = html:gsub('^<math display="inline" xmlns="[^"]*"', "<math") -- HTML needs neither
    :gsub('^<math display="block" xmlns="[^"]*"', '<math display="block"')
    :gsub("<semantics>(.*)<annotation.*</semantics>", "%1"):gsub("^(<math[^>]*>)<mrow>(.*)</mrow></math>$", "%1%2</math>")
  return (settle_brackets(html, kind):gsub('(<mo stretchy="%l+") form="%l+">([%(%)%[%]])', "%1>%2") -- no other form
    :gsub("(<mspace[^>]*)></mspace>", "%1/>"))
end

-- Half of a page's formulas have stood in it before.
local made = {}

return function(tex, kind)
  local key = kind .. tex
  if made[key] == nil then made[key] = written(tex, kind) or false end
  return made[key] or nil
end
